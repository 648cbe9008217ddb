// The shortest paths to points of one face over a solver's sources, and the points equally far from three generators.
//
// A source's path is straight if its image sees the point through its opening, and otherwise bends round an end of the
// opening. It always lies on the surface, so that the shortest over all sources is the distance itself. Equidistant
// points come from Newton's method on the differences of three distances. The method is damped, because the shortest
// path may change from one source to another on the way. A result counts only if the three distances agree up to
// rounding.
//
// Such a search stagnates at ridges of the distances, where the shortest path changes from one source to another.
// Solving every triple of sources would take cubic time, and beside needles a generator has hundreds of sources. So the
// face is halved repeatedly. Distances change by at most the way between two points. A part of the face therefore drops
// the sources that are hidden from it, or farther than another source everywhere in it, and is dropped itself if the
// three distances can't be equal in it. When few sources are left, their triples are solved.
#include "diagram/envelope/source_distances.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/plane.hpp"
#include "base/roots.hpp"

namespace gvd {
namespace {

/// Up to this many triples of sources, solving all of them costs less than halving the cell.
constexpr std::size_t kFewTriples = 64;

/// Largest number of halvings of a cell, after which its sides are a millionth of the face's sides.
constexpr int kMostHalvings = 40;

/// Largest number of cells in a search. Along a curve of ties, the number of cells would double with every second
/// halving. Beyond this number, the middle of a cell stands for the candidates in it.
constexpr int kMostCells = 2000;

/// A ray that passes its opening at up to this fraction of its length still counts, because rays that are unfolded over
/// hundreds of thin faces are off by 1e-9 of their length.
constexpr double kBesideOpening = 1e-6;

/// Two distances that differ by less than this fraction of themselves may be equal, and a point may lie beside a disc
/// by this fraction of the disc's radius.
constexpr double kBeside = 1e-6;

/// Whether a straight path of a source may pass its opening and reach the disc.
bool may_see(const FaceSource& s, const Vec2& middle, double radius) {
  if (s.is_corner()) return true;
  if (s.is_parallel()) {
    const double slack = radius + kBesideOpening * (middle - s.begin).norm();
    return s.beside(middle, s.begin) >= -slack && s.beside(middle, s.end) <= slack;
  }
  const Vec2 ray = middle - s.image, left = s.begin - s.image, right = s.end - s.image;
  const double slack = radius + kBesideOpening * ray.norm();
  return cross(ray, left) >= -slack * left.norm() && cross(ray, right) <= slack * right.norm();
}

/// A point p with its distance d from a generator, relative to the image and the offset of a first source. This is a
/// point of the cone |p| = d.
using OnCone = Vec3;

/// The points whose distance from a second image differs from d by the difference of the offsets. They form a plane,
/// because the difference of |p|^2 = d^2 and |p - image|^2 = (d - offset)^2 is linear.
struct Plane {
  Vec3 normal;
  double level;
  /// The plane of source s, relative to the image of `first`. Distances along parallel paths are already linear.
  Plane(const FaceSource& s, const FaceSource& first) {
    if (s.is_parallel()) {
      normal = {s.direction().x(), s.direction().y(), -1};
      level = first.offset - s.distance_begin - s.direction().dot(first.image - s.begin);
    } else {
      const Vec2 image = s.image - first.image;
      const double offset = s.offset - first.offset;
      normal = {image.x(), image.y(), -offset};
      level = 0.5 * (image.squaredNorm() - offset * offset);
    }
  }
};

/// Appends the point where the parallel paths of three sources are equally long. The lengths are linear, so that the
/// point solves two linear equations. Appends nothing if two directions are the same.
void append_parallel_point(const FaceSource& a, const FaceSource& b, const FaceSource& c, std::vector<Vec2>& points) {
  const auto start = [](const FaceSource& s) { return s.distance_begin - s.direction().dot(s.begin); };
  const Vec2 first = a.direction() - b.direction(), second = a.direction() - c.direction();
  const Vec2 levels(start(b) - start(a), start(c) - start(a));
  const Vec2 p =
      Vec2(second.y() * levels.x() - first.y() * levels.y(), first.x() * levels.y() - second.x() * levels.x()) /
      cross(first, second);
  if (p.allFinite()) points.push_back(p);
}

/// Appends the points of the cone that lie on both planes. `tip` is the position of the cone's tip in the face.
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

/// Three distances that differ by less than this fraction of themselves count as equal. It is a few units in the last
/// place of sums of three terms.
constexpr double kEqualDistance = 1e-14;

/// Difference that is accepted when Newton's steps no longer improve it, as a fraction of the distance. It allows for
/// the rounding of a point far from its images.
constexpr double kResidual = 1e-12;

/// Another generator that is nearer by up to this fraction of the distance counts as equally far; the branch point has
/// degree four then.
constexpr double kEquallyFar = 1e-12;

/// Largest difference of the two distances at a crossing, as a fraction of them. The envelope takes them for equal
/// within a quarter of this, and they are rounded sums.
constexpr double kCrossingError = 4e-14;

/// Points whose three distances differ by less than this fraction of themselves are candidates for branch points, from
/// which Newton's method starts.
constexpr double kNearlyEqual = 1e-6;

constexpr int kMostNewtonSteps = 40, kStepHalvings = 6;

/// Moves a point that lies on a side, or a little beyond it, inside the face.
Bary moved_inside(Bary bary) {
  const double least = *std::min_element(bary.begin(), bary.end());
  if (least >= kInsideFace || least < -kBeyondFace) return bary;
  double sum = 0;
  for (double& b : bary) sum += b = std::max(b, kInsideFace);
  for (double& b : bary) b /= sum;
  return bary;
}

/// The shortest paths of three generators to a point.
struct ThreePaths {
  Vec2 p;
  FaceSource::Path a, b, c;
  Vec2 error() const { return {a.distance - b.distance, a.distance - c.distance}; }
  double size() const { return error().cwiseAbs().maxCoeff(); }
  bool are_equal() const { return !(size() > kEqualDistance * a.distance); }
  /// Newton's step to the point where the three paths are equally long, if they keep their last straight pieces.
  Vec2 newton_step() const {
    const Vec2 u = direction(p, a.from), v = direction(p, b.from), w = direction(p, c.from);
    const Vec2 first = u - v, second = u - w, e = error();
    const double determinant = cross(first, second);
    return {(second.y() * e.x() - first.y() * e.y()) / -determinant,
            (first.x() * e.y() - second.x() * e.x()) / -determinant};
  }
};

}  // namespace

void append_equidistant_points(std::span<const FaceSource> a, std::span<const FaceSource> b,
                               std::span<const FaceSource> c, std::vector<Vec2>& points) {
  for (const FaceSource& first : a) {
    for (const FaceSource& second : b) {
      for (const FaceSource& third : c) {
        // The cone belongs to the first source that has an image.
        if (!first.is_parallel()) {
          append_common_points(Plane(second, first), Plane(third, first), first.image, points);
        } else if (!second.is_parallel()) {
          append_common_points(Plane(first, second), Plane(third, second), second.image, points);
        } else if (!third.is_parallel()) {
          append_common_points(Plane(first, third), Plane(second, third), third.image, points);
        } else {
          append_parallel_point(first, second, third, points);
        }
      }
    }
  }
}

/// A disc that contains a cell, and the shortest paths of the three generators to its centre.
struct EquidistantSearch::Disc {
  Vec2 middle;
  double radius = 0;
  std::array<NearestSource, 3> nearest{};

  explicit Disc(const Cell& cell) : middle((cell[0] + cell[1] + cell[2]) / 3) {
    for (const Vec2& corner : cell) radius = std::max(radius, (corner - middle).norm());
  }
  /// Whether a source may be its generator's nearest source somewhere in the disc. No path is shorter than the straight
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
  for (std::size_t i = 0; i < 3; ++i) disc.nearest[i] = nearest(sources(lists, i), disc.middle);
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

/// Pushes the sources that may be the nearest in the disc on the stack.
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

/// Solves all triples of sources, and keeps the points in the disc. The discs of neighbouring cells overlap, so that a
/// point may be found twice, with the same bits.
void EquidistantSearch::solve(const Disc& disc, const Lists& lists) {
  solved_.clear();
  append_equidistant_points(sources(lists, 0), sources(lists, 1), sources(lists, 2), solved_);
  for (const Vec2& p : solved_) {
    const bool is_near = (p - disc.middle).norm() <= (1 + kBeside) * disc.radius;
    if (is_near && std::find(found_.begin(), found_.end(), p) == found_.end()) found_.push_back(p);
  }
}

void SourceDistances::enter(const Mesh& mesh, FaceId f) {
  layout_.emplace(mesh, f);
  field_.collect(f, *layout_, found_);
  sources_.build(found_);
}

void SourceDistances::enter_with_offsets(const SourceDistances& others, const SymbolicOffset& offset) {
  layout_ = others.layout_;
  sources_ = others.sources_;
  for (FaceSource& source : sources_.all()) {
    const double longer = offset.of(source.generator);
    source.offset += longer;
    source.distance_begin += longer;
    source.distance_end += longer;
  }
}

std::optional<double> SourceDistances::entry(GeneratorId g, const Bary& bary) const {
  const Vec2 p = layout_->at(bary);
  const NearestSource best = gvd::nearest(sources(g), p);
  if (best.source == nullptr) return std::nullopt;
  const int side = Mesh::corner(best.source->halfedge);
  if (best.source->is_corner()) return side;
  const Vec2 start = layout_->corner[side];
  const Vec2 along = layout_->corner[(side + 1) % 3] - start;
  return side + nearest_on_segment(start, along, best.source->entry(p));
}

double SourceDistances::at(GeneratorId g, const Bary& p) const { return nearest(g, layout_->at(p)).distance; }

std::optional<Bary> SourceDistances::equidistant(GeneratorId a, GeneratorId b, GeneratorId c, const Bary& start) const {
  const auto paths_to = [&](const Vec2& p) { return ThreePaths{p, nearest(a, p), nearest(b, p), nearest(c, p)}; };
  ThreePaths paths = paths_to(layout_->at(start));
  const double longest =
      (layout_->corner[1] - layout_->corner[0]).norm() + (layout_->corner[2] - layout_->corner[1]).norm();
  for (int i = 0; i < kMostNewtonSteps && !paths.are_equal(); ++i) {
    Vec2 step = paths.newton_step();
    if (!step.allFinite()) break;
    if (step.norm() > longest) step *= longest / step.norm();
    ThreePaths next = paths_to(paths.p + step);
    for (int half = 0; half < kStepHalvings && !(next.size() < paths.size()); ++half) {
      step *= 0.5;
      next = paths_to(paths.p + step);
    }
    if (!(next.size() < paths.size())) break;
    paths = next;
  }
  // A distance is infinite if the face has no source of the generator.
  if (std::isinf(paths.a.distance) || !(paths.size() <= kResidual * paths.a.distance)) return std::nullopt;
  return moved_inside(layout_->bary(paths.p));
}

std::vector<Bary> SourceDistances::equidistant_points(GeneratorId a, GeneratorId b, GeneratorId c) const {
  std::vector<Bary> found;
  for (const Vec2& p : search_.find(*layout_, sources(a), sources(b), sources(c))) {
    const Bary bary = layout_->bary(p);
    if (!(*std::min_element(bary.begin(), bary.end()) > -kBeyondFace)) continue;
    const auto [least, most] = std::minmax({at(a, bary), at(b, bary), at(c, bary)});
    if (most - least <= kNearlyEqual * least) found.push_back(bary);
  }
  return found;
}

double SourceDistances::crossing_error(const BoundaryCrossing& crossing) const {
  const Vec2 p = layout_->at(crossing.bary());
  const auto before = nearest(crossing.previous, p), after = nearest(crossing.next, p);
  const double rate =
      std::abs((direction(p, before.from) - direction(p, after.from)).dot(layout_->side(crossing.corner)));
  const double length = (layout_->corner[(crossing.corner + 1) % 3] - layout_->corner[crossing.corner]).norm();
  return kCrossingError * before.distance / (rate * length);
}

bool SourceDistances::is_branch_point(GeneratorId a, GeneratorId b, GeneratorId c, const Bary& bary) const {
  if (*std::min_element(bary.begin(), bary.end()) < kInsideFace * (1 - 1e-3)) return false;
  const Vec2 p = layout_->at(bary);
  const auto path_a = nearest(a, p), path_b = nearest(b, p), path_c = nearest(c, p);
  for (const FaceSource& s : sources_.all()) {
    if (s.generator == a || s.generator == b || s.generator == c) continue;
    if (s.shortest_path(p).distance < path_a.distance * (1 - kEquallyFar)) return false;
  }
  const Vec2 u = direction(p, path_a.from), v = direction(p, path_b.from), w = direction(p, path_c.from);
  return twice_signed_area(u, v, w) > 0;
}

}  // namespace gvd
