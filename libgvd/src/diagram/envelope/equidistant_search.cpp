// The points of a face that are equally far from three generators: candidates for branch points.
//
// A search along the distances themselves stagnates at their ridges, where the shortest path changes from one source to
// another. To solve every triple of sources is cubic, and beside needles a generator has hundreds of sources. So the
// face is halved again and again. Distances change by at most the way between two points. Hence a cell drops the
// sources that are hidden from it, or farther than another one everywhere in it. The whole cell is dropped where the
// three distances can't be equal. Where few sources are left, their triples are solved.
#include "diagram/envelope/equidistant_search.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/plane.hpp"
#include "base/roots.hpp"
#include "diagram/envelope/source_distances.hpp"

namespace gvd {
namespace {

/// With at most so many triples of sources, solving all of them costs less than halving the cell.
constexpr std::size_t kFewTriples = 64;

/// A cell is halved at most so often: its sides are then a millionth of the face's.
constexpr int kMostHalvings = 40;

/// Cells of one search. Along a curve of ties their number would double with each second halving. Beyond this number,
/// the middle of a cell stands for the candidates in it.
constexpr int kMostCells = 2000;

/// A ray that passes beside its opening still counts, by this fraction of its length: rays unfolded over hundreds of
/// thin faces are off by 1e-9 of it.
constexpr double kBesideOpening = 1e-6;

/// Two distances that differ by less than this fraction of themselves may be equal. A point may lie beside a disc by
/// this fraction of its radius.
constexpr double kBeside = 1e-6;

/// Whether a straight path of a source may pass its opening and reach the disc.
bool may_see(const FaceSource& s, const Vec2& middle, double radius) {
  if (s.is_corner) return true;
  const Vec2 ray = middle - s.image, left = s.begin - s.image, right = s.end - s.image;
  const double slack = radius + kBesideOpening * ray.norm();
  return cross(ray, left) >= -slack * left.norm() && cross(ray, right) <= slack * right.norm();
}

/// A point p with its distance d to a generator, relative to the image of a first source and its offset: a point of the
/// cone |p| = d.
using OnCone = Vec3;

/// The points whose distance to a second image differs from d by the difference of the offsets. They form a plane,
/// because |p|^2 = d^2 minus |p - image|^2 = (d - offset)^2 is linear.
struct Plane {
  Vec3 normal;
  double level;
  Plane(const Vec2& image, double offset)
      : normal(image.x(), image.y(), -offset), level(0.5 * (image.squaredNorm() - offset * offset)) {}
};

/// Appends the points of the cone that lie on both planes. `tip`: the cone's tip in the face.
void append_common_points(const Plane& first, const Plane& second, const Vec2& tip, std::vector<Vec2>& points) {
  const Vec3 normals = first.normal.cross(second.normal);
  const double size = normals.norm();
  if (!(size > 0)) return;
  const Vec3 along = normals / size;
  const OnCone start = (first.level * second.normal - second.level * first.normal).cross(along) / size;
  const auto product = [](const Vec3& u, const Vec3& v) { return u.x() * v.x() + u.y() * v.y() - u.z() * v.z(); };
  // The common line of the planes is start + t along; it intersects |p|^2 = d^2 in the roots.
  for (const double t : quadratic_roots(product(along, along), product(start, along), product(start, start))) {
    if (std::isfinite(t)) points.push_back(tip + (start + t * along).head<2>());
  }
}

}  // namespace

void append_equidistant_points(std::span<const FaceSource> a, std::span<const FaceSource> b,
                               std::span<const FaceSource> c, std::vector<Vec2>& points) {
  for (const FaceSource& first : a) {
    for (const FaceSource& second : b) {
      const Plane plane(second.image - first.image, second.offset - first.offset);
      for (const FaceSource& third : c) {
        append_common_points(plane, Plane(third.image - first.image, third.offset - first.offset), first.image, points);
      }
    }
  }
}

/// A disc that contains a cell, and the shortest paths of the three generators to its centre.
struct EquidistantSearch::Disc {
  Vec2 middle;
  double radius = 0;
  std::array<SourceDistances::Nearest, 3> nearest{};

  explicit Disc(const Cell& cell) : middle((cell[0] + cell[1] + cell[2]) / 3) {
    for (const Vec2& corner : cell) radius = std::max(radius, (corner - middle).norm());
  }
  /// Whether a source may be its generator's nearest one somewhere in the disc: no path is shorter than the straight
  /// one, and both distances change by at most the radius.
  bool may_be_nearest(const FaceSource& s, std::size_t generator) const {
    const double least = nearest[generator].path.distance, rest = (1 + kBeside) * least + 2 * radius - s.offset;
    return rest >= 0 && (middle - s.image).squaredNorm() <= rest * rest && may_see(s, middle, radius);
  }
  bool may_be_equal() const {
    const auto [least, most] =
        std::minmax({nearest[0].path.distance, nearest[1].path.distance, nearest[2].path.distance});
    return most - least <= 2 * radius + kBeside * most;
  }
};

const std::vector<Vec2>& EquidistantSearch::find(const FaceLayout& face, std::span<const FaceSource> a,
                                                 std::span<const FaceSource> b, std::span<const FaceSource> c) {
  found_.clear();
  cells_ = 0;
  stack_.assign(a.begin(), a.end());
  stack_.insert(stack_.end(), b.begin(), b.end());
  stack_.insert(stack_.end(), c.begin(), c.end());
  search(face.corner, {0, a.size(), a.size() + b.size(), stack_.size()}, 0);
  return found_;
}

void EquidistantSearch::search(const Cell& cell, const Lists& lists, int halvings) {
  const std::size_t top = stack_.size();
  ++cells_;
  Disc disc(cell);
  for (std::size_t i = 0; i < 3; ++i) disc.nearest[i] = SourceDistances::nearest(sources(lists, i), disc.middle);
  if (disc.may_be_equal()) {
    const Lists kept = keep_relevant(disc, lists);
    const std::size_t triples = (kept[1] - kept[0]) * (kept[2] - kept[1]) * (kept[3] - kept[2]);
    if (triples <= kFewTriples) {
      solve(disc, kept);
    } else if (halvings == kMostHalvings || cells_ >= kMostCells) {
      found_.push_back(disc.middle);
    } else {
      search_halves(cell, kept, halvings + 1);
    }
  }
  stack_.resize(top);
}

/// Puts the sources that matter in the disc on the stack.
EquidistantSearch::Lists EquidistantSearch::keep_relevant(const Disc& disc, const Lists& lists) {
  Lists kept{stack_.size()};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = lists[i]; k < lists[i + 1]; ++k) {
      if (disc.may_be_nearest(stack_[k], i)) stack_.push_back(FaceSource(stack_[k]));
    }
    kept[i + 1] = stack_.size();
  }
  return kept;
}

/// Searches the two halves of a cell on either side of the middle of its longest side.
void EquidistantSearch::search_halves(const Cell& cell, const Lists& lists, int halvings) {
  const auto length = [&](std::size_t i) { return (cell[(i + 1) % 3] - cell[i]).squaredNorm(); };
  std::size_t longest = 0;
  for (std::size_t i = 1; i < 3; ++i) longest = length(i) > length(longest) ? i : longest;
  const Vec2 from = cell[longest], to = cell[(longest + 1) % 3], apex = cell[(longest + 2) % 3];
  const Vec2 middle = 0.5 * (from + to);
  search({apex, from, middle}, lists, halvings);
  search({apex, middle, to}, lists, halvings);
}

/// Discs of neighbouring cells overlap. So a point may be found twice, with the same bits.
void EquidistantSearch::solve(const Disc& disc, const Lists& lists) {
  solved_.clear();
  append_equidistant_points(sources(lists, 0), sources(lists, 1), sources(lists, 2), solved_);
  for (const Vec2& p : solved_) {
    const bool is_near = (p - disc.middle).norm() <= (1 + kBeside) * disc.radius;
    if (is_near && std::find(found_.begin(), found_.end(), p) == found_.end()) found_.push_back(p);
  }
}

}  // namespace gvd
