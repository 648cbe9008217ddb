#include "diagram/envelope/equidistant_search.hpp"

#include <algorithm>
#include <cmath>

#include "base/plane.hpp"
#include "diagram/envelope/equidistant_points.hpp"
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

}  // namespace

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
