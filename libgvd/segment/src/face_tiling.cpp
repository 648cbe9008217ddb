// Fits the pieces of a face together, so that adjacent polygons share whole segments.
//
// Pieces come from both sides of each bisector with their own rounding. Corners that coincide are merged, and segments
// are split at the corners on them. The result is used only if it tiles the face: each directed segment occurs once,
// and its reverse occurs once in another polygon or on the border. The corners of the border come first and are never
// merged or moved, because the adjacent faces share them. Corners are sorted along the face's longest side and along an
// axis of space, so that a face with many pieces needs no search over all pairs.
#include "face_tiling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace gvd {
namespace {

bool coincide(const Bary& a, const Bary& b) {
  return std::abs(a[0] - b[0]) <= kCutWeld && std::abs(a[1] - b[1]) <= kCutWeld && std::abs(a[2] - b[2]) <= kCutWeld;
}

/// Splits a closed walk over corners (numbers below `corners`) into simple loops, wherever it repeats a corner. Drops
/// loops of two corners.
std::vector<std::vector<std::size_t>> split_at_repeats(const std::vector<std::size_t>& walk, std::size_t corners) {
  std::vector<std::vector<std::size_t>> loops;
  std::vector<std::size_t> stack;
  std::vector<char> is_on_stack(corners, 0);
  for (const std::size_t corner : walk) {
    if (is_on_stack[corner]) {
      const auto again = std::find(stack.begin(), stack.end(), corner);
      if (stack.end() - again >= 3) loops.emplace_back(again, stack.end());
      for (auto left = again; left != stack.end(); ++left) is_on_stack[*left] = 0;
      stack.erase(again, stack.end());
    }
    stack.push_back(corner);
    is_on_stack[corner] = 1;
  }
  if (stack.size() >= 3) loops.push_back(std::move(stack));
  return loops;
}

/// The largest difference along a side between two points whose barycentric coordinates differ by kCutWeld each. The
/// position along a side is a mean of numbers from 0 to 1 with the coordinates as weights.
constexpr double kAlongWeld = 3 * kCutWeld;

/// The positions of the face's corners, projected onto its longest side, from 0 to 1. `border` begins with a corner.
std::array<double, 3> positions_along_longest_side(const std::vector<FaceTiling::Corner>& border) {
  std::array<Vec3, 3> corner{};
  for (const FaceTiling::Corner& c : border) {
    for (int i = 0; i < 3; ++i) {
      if (c.bary[i] == 1) corner[i] = c.position;
    }
  }
  int longest = 0;
  for (int i = 1; i < 3; ++i) {
    if ((corner[(i + 1) % 3] - corner[i]).norm() > (corner[(longest + 1) % 3] - corner[longest]).norm()) longest = i;
  }
  const int end = (longest + 1) % 3, apex = (longest + 2) % 3;
  std::array<double, 3> positions{};
  positions[end] = 1;
  positions[apex] = std::clamp(foot_on_line(corner[longest], corner[end], corner[apex]), 0.0, 1.0);
  return positions;
}

/// A segment from one corner to another.
using DirectedSegment = std::pair<std::size_t, std::size_t>;

/// Whether each segment and its reverse occur exactly once.
bool is_paired(std::vector<DirectedSegment> segments) {
  std::vector<DirectedSegment> reverse;
  for (const auto& [from, to] : segments) reverse.emplace_back(to, from);
  std::sort(segments.begin(), segments.end());
  std::sort(reverse.begin(), reverse.end());
  return segments == reverse && std::adjacent_find(segments.begin(), segments.end()) == segments.end();
}

}  // namespace

double position_tolerance(const Mesh& mesh) {
  return kPositionUlps * std::numeric_limits<double>::epsilon() * mesh.largest_coordinate();
}

std::span<const std::pair<double, std::size_t>> FaceTiling::SortedCorners::between(double low, double high) const {
  const auto coordinate = [](const auto& item) { return item.first; };
  return {std::to_address(std::ranges::lower_bound(corners_, low, {}, coordinate)),
          std::to_address(std::ranges::upper_bound(corners_, high, {}, coordinate))};
}

template <class Test>
std::size_t FaceTiling::SortedCorners::find(double coordinate, double tolerance, std::size_t limit,
                                            const Test& passes) const {
  // The range is twice as wide as the tolerance, so that rounding of its ends excludes no corner.
  for (const auto& [at, corner] : between(coordinate - 2 * tolerance, coordinate + 2 * tolerance)) {
    if (corner < limit && passes(corner)) limit = corner;
  }
  return limit;
}

FaceTiling::FaceTiling(std::vector<Corner> border, double tolerance)
    : corners_(std::move(border)), border_(corners_.size()), tolerance_(tolerance) {
  Vec3 low = corners_[0].position, high = low;
  for (const Corner& corner : corners_) {
    low = low.cwiseMin(corner.position);
    high = high.cwiseMax(corner.position);
  }
  (high - low).maxCoeff(&axis_);
  along_ = positions_along_longest_side(corners_);
  for (std::size_t i = 0; i < border_; ++i) {
    index(i);
    by_vertex_.emplace_back(corners_[i].vertex, i);
  }
  std::sort(by_vertex_.begin(), by_vertex_.end());
}

/// The first corner of the border with this vertex; the number of all corners if there is none.
std::size_t FaceTiling::find_vertex(VertexId vertex) const {
  const auto found = std::ranges::lower_bound(by_vertex_, std::pair(vertex, std::size_t{0}));
  return found != by_vertex_.end() && found->first == vertex ? found->second : corners_.size();
}

std::size_t FaceTiling::find_or_add(const Corner& corner) {
  std::size_t found = corners_.size();
  if (corner.vertex.valid()) {
    found = find_vertex(corner.vertex);
  } else {
    found = by_along_.find(along(corner), kAlongWeld, found,
                           [&](std::size_t i) { return coincide(corners_[i].bary, corner.bary); });
    found = by_position_.find(corner.position[axis_], tolerance_, found, [&](std::size_t i) {
      return coincide(corners_[i].position, corner.position, tolerance_);
    });
  }
  if (found < corners_.size()) return found;
  corners_.push_back(corner);
  index(found);
  return found;
}

bool FaceTiling::fit() {
  // Most pieces already share their corners. Splitting at every corner near a segment is only the second attempt,
  // because in a piece thinner than kCutWeld it would fold one side onto the other.
  for (const double tolerance : {0.0, kCutWeld}) {
    std::vector<Polygon> fitted;
    for (const Polygon& polygon : polygons_) {
      for (std::vector<std::size_t>& loop :
           split_at_repeats(split_segments(polygon.corners, tolerance), corners_.size())) {
        fitted.push_back({polygon.generator, std::move(loop)});
      }
    }
    if (!tiles(fitted)) continue;
    polygons_ = std::move(fitted);
    return true;
  }
  return false;
}

void FaceTiling::leave_whole(GeneratorId generator) {
  corners_.resize(border_);
  Polygon whole{generator, {}};
  for (std::size_t i = 0; i < border_; ++i) whole.corners.push_back(i);
  polygons_.assign(1, whole);
}

std::vector<std::size_t> FaceTiling::split_segments(const std::vector<std::size_t>& polygon, double tolerance) const {
  std::vector<std::size_t> split;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t from = polygon[i], to = polygon[(i + 1) % polygon.size()];
    if (from == to) continue;
    split.push_back(from);
    append_corners_between(from, to, tolerance, split);
  }
  return split;
}

void FaceTiling::append_corners_between(std::size_t from, std::size_t to, double tolerance,
                                        std::vector<std::size_t>& out) const {
  const Vec2 start = plane_point(from), chord = plane_point(to) - start;
  const double length = chord.norm();
  const auto [low, high] = std::minmax({along(corners_[from]), along(corners_[to])});
  std::vector<std::pair<double, std::size_t>> between;
  // A point on an edge of the face is off the edge only by rounding, which is less than kCutWeld.
  for (const auto& [position, k] : by_along_.between(low - 2 * kAlongWeld, high + 2 * kAlongWeld)) {
    if (k == from || k == to) continue;
    const Vec2 offset = plane_point(k) - start;
    const double t = chord.dot(offset) / (length * length);
    const double away = std::abs(cross(chord, offset)) / length;
    if (t > 0 && t < 1 && (away <= tolerance || on_one_edge(from, to, k))) between.emplace_back(t, k);
  }
  std::sort(between.begin(), between.end());
  for (const auto& [t, k] : between) out.push_back(k);
}

bool FaceTiling::on_one_edge(std::size_t a, std::size_t b, std::size_t c) const {
  for (int i = 0; i < 3; ++i) {
    if (corners_[a].bary[i] == 0 && corners_[b].bary[i] == 0 && corners_[c].bary[i] == 0) return true;
  }
  return false;
}

bool FaceTiling::tiles(const std::vector<Polygon>& polygons) const {
  std::vector<DirectedSegment> segments;
  for (std::size_t i = 0; i < border_; ++i) segments.emplace_back((i + 1) % border_, i);
  for (const Polygon& polygon : polygons) {
    const std::vector<std::size_t>& corners = polygon.corners;
    const auto corner = [&](std::size_t i) { return plane_point(corners[i]); };
    if (twice_signed_area(corners.size(), corner) < -kCutWeld) return false;
    for (std::size_t i = 0; i < corners.size(); ++i)
      segments.emplace_back(corners[i], corners[(i + 1) % corners.size()]);
  }
  return is_paired(std::move(segments));
}

}  // namespace gvd
