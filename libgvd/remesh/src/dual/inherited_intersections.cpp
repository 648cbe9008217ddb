// The pairs of faces of a remesh that may intersect, because the surface intersects itself there.
//
// Cells tell whether two sheets of the surface intersect at all. Places in space, and the number of pairs there, keep a
// single crossing of two slivers from excusing every fold near it. A pair of the surface excuses one pair of the
// remesh, and then leaves the tree of boxes.
#include "dual/inherited_intersections.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <optional>
#include <tuple>
#include <utility>

#include "base/box_tree.hpp"
#include "dual/flipped_triangles.hpp"
#include "dual/order_in_space.hpp"
#include "dual/self_intersections.hpp"
#include "gvd/sampling.hpp"

namespace gvd {
namespace {

/// On average over directions, a line crosses 2.2 equilateral triangles for each side length (Crofton). If two surfaces
/// meet along it, 4.4 pairs of triangles meet for each side length. Twice as many allow for irregular triangles.
constexpr double kPairsPerSpacing = 9;

/// Triangles whose normals have a smaller sine between them are parallel: rounding hides where they cross.
constexpr double kParallel = 1e-6;

Vec3 normal_of(const Triangle& t) { return (t[1] - t[0]).cross(t[2] - t[0]); }

bool are_parallel(const Triangle& first, const Triangle& second) {
  const Vec3 a = normal_of(first), b = normal_of(second);
  return !(a.cross(b).norm() > kParallel * a.norm() * b.norm());
}

Box3 box_of(const Triangle& t) { return {t[0].cwiseMin(t[1]).cwiseMin(t[2]), t[0].cwiseMax(t[1]).cwiseMax(t[2])}; }

double longest_side(const Triangle& t) {
  return std::max({(t[1] - t[0]).norm(), (t[2] - t[1]).norm(), (t[0] - t[2]).norm()});
}

/// Two points of one line, by their places along its direction.
struct Stretch {
  double begin = kInfinity, end = -kInfinity;
  Vec3 first, last;

  void extend(const Vec3& point, const Vec3& direction) {
    const double at = point.dot(direction);
    if (at < begin) std::tie(begin, first) = std::pair(at, point);
    if (at > end) std::tie(end, last) = std::pair(at, point);
  }
};

/// Where a triangle crosses the plane of another one; empty if rounding says that it does not.
Stretch cross_plane(const Triangle& triangle, const Vec3& at, const Vec3& normal, const Vec3& direction) {
  Stretch stretch;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 &p = triangle[i], &q = triangle[(i + 1) % 3];
    const double from = (p - at).dot(normal), to = (q - at).dot(normal);
    if (from == 0) stretch.extend(p, direction);
    if ((from < 0) != (to < 0) && from != to) stretch.extend(p + from / (from - to) * (q - p), direction);
  }
  return stretch;
}

/// The pairs of the surface that no pair of the remesh has taken yet.
class UntakenPairs {
 public:
  UntakenPairs(const Mesh& surface, const std::vector<FacePair>& given, double spacing) : given_(given) {
    const PlacedFaces faces(surface);
    std::vector<Box3> boxes;
    std::vector<Vec3> middles;
    for (const FacePair& pair : given) {
      const Triangle first = faces.corners(pair.first), second = faces.corners(pair.second);
      boxes.push_back(meeting_box(first, second));
      middles.push_back(boxes.back().center());
      const double length = boxes.back().diagonal().norm() / spacing;
      const double size = are_parallel(first, second) ? length * length : length;
      count_.push_back(length < 1 ? 1 : static_cast<std::int64_t>(std::ceil(kPairsPerSpacing * size)));
    }
    given_at_ = order_in_space(middles);
    slot_.resize(given.size());
    for (std::size_t slot = 0; slot < given_at_.size(); ++slot) slot_[given_at_[slot]] = slot;
    tree_.build(given_at_.size(), [&](std::size_t slot) { return boxes[given_at_[slot]]; });
  }

  void take(const FacePair& pair) {
    const auto found = std::lower_bound(given_.begin(), given_.end(), pair);
    if (found != given_.end() && *found == pair) take_slot(slot_[found - given_.begin()]);
  }

  /// Takes a pair that is at most so far from a box, if there is one.
  bool take_near(const Box3& box, double distance) {
    const auto is_near = [&](const Box3& other) { return other.squaredExteriorDistance(box) <= distance * distance; };
    const std::size_t slot = tree_.find(0, is_near);
    if (slot == Tree::kNone) return false;
    take_slot(slot);
    return true;
  }

 private:
  using Tree = BoxTreeOf<Box3>;

  void take_slot(std::size_t slot) {
    std::int64_t& count = count_[given_at_[slot]];
    if (--count == 0) tree_.remove(slot);
  }

  const std::vector<FacePair>& given_;
  std::vector<std::int64_t> count_;  // how often each may be taken
  std::vector<std::int32_t> given_at_;
  std::vector<std::size_t> slot_;  // in the tree, of each pair
  Tree tree_;
};

bool is_own(const RemeshFaces& faces, FaceId f) {
  return is_surface_triangle(faces.surface, faces.remesh, f, faces.diagram.generators, faces.face_points);
}

}  // namespace

Box3 meeting_box(const Triangle& first, const Triangle& second) {
  const Box3 common = box_of(first).intersection(box_of(second));
  if (are_parallel(first, second)) return common;
  const Vec3 a = normal_of(first), b = normal_of(second), direction = a.cross(b);
  const Stretch of_first = cross_plane(first, second[0], b, direction);
  const Stretch of_second = cross_plane(second, first[0], a, direction);
  const Stretch& late = of_first.begin < of_second.begin ? of_second : of_first;
  const Stretch& early = of_first.end < of_second.end ? of_first : of_second;
  if (!(late.begin <= early.end)) return common;
  Box3 box(late.first);
  box.extend(early.last);
  const Box3 met = box.intersection(common);
  return met.isEmpty() ? common : met;
}

std::vector<FacePair> find_inherited_pairs(const RemeshFaces& faces, const std::vector<FacePair>& pairs,
                                           const std::vector<FacePair>& given, const Progress& progress) {
  if (pairs.empty() || given.empty()) return {};
  const Mesh &surface = faces.surface, &remesh = faces.remesh;
  const std::vector<SurfacePoint>& face_points = faces.face_points;
  UntakenPairs untaken(surface, given, even_spacing(compute_area(surface), remesh.vertex_count()));
  std::vector<FacePair> inherited, candidates, others;
  for (const FacePair& pair : pairs) {
    if (is_own(faces, pair.first) && is_own(faces, pair.second)) {
      const auto [f, g] = std::minmax(face_points[pair.first.index()].face, face_points[pair.second.index()].face);
      untaken.take({f, g});
      inherited.push_back(pair);
    } else {
      (faces.is_decimated(pair.first) && faces.is_decimated(pair.second) ? candidates : others).push_back(pair);
    }
  }
  if (!others.empty()) {
    const auto cells = find_intersecting_cells(surface, faces.diagram, given, progress);
    std::ranges::copy(find_inherited(remesh, others, cells), std::back_inserter(candidates));
  }
  const PlacedFaces placed(remesh);
  std::vector<std::pair<double, FacePair>> by_size;
  for (const FacePair& pair : candidates) {
    by_size.emplace_back(std::max(longest_side(placed.corners(pair.first)), longest_side(placed.corners(pair.second))),
                         pair);
  }
  std::sort(by_size.begin(), by_size.end());
  for (const auto& [size, pair] : by_size) {
    const Box3 box = meeting_box(placed.corners(pair.first), placed.corners(pair.second));
    if (untaken.take_near(box, size)) inherited.push_back(pair);
  }
  std::sort(inherited.begin(), inherited.end());
  return inherited;
}

}  // namespace gvd
