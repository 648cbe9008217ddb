// Finds the point of a surface that is closest to a point in space.
//
// The search uses a tree of bounding boxes, which halves the faces at the median of their centres along the longest
// axis of their box. Its leaves have at most four entries: faces, or slices of them. A search visits the nearer box
// first, with the nearest face as a first bound.
//
// A needle that is oblique to the axes has a box that is far larger than itself: among thousands of them, each query
// lies in nearly all boxes. So the tree holds a needle as several slices with a box each; a slice that is visited
// measures the distance of its whole face, which is right for every slice of it. And where most needles have one
// direction, as on a rod, the boxes follow the principal axes of the mesh.
// Source: C. Ericson, Real-time collision detection, 2005, section 5.1.5, for the tree's quick distance from a
// triangle: first the region of the plane, then the projection. `closest_point_on_face` is slower, and has the last
// word.
// Invariant: `query` skips a box only if it is farther away than the best face by more than rounding. So the result
// does not depend on the shape of the tree: the least distance wins, and among equal distances the face with the
// smallest id.
#include "gvd/closest_point.hpp"

#include <algorithm>
#include <limits>
#include <set>
#include <tuple>
#include <type_traits>

#include "base/barycentric.hpp"
#include "gvd/error.hpp"
#include "mesh/box_frame.hpp"

namespace gvd {
namespace {

constexpr std::int32_t kLeafFaces = 4;
/// A box is skipped if it is farther away than the best face by more than this fraction of the distance. Dimensionless.
/// It is far above the rounding of the two distances (about ten units in the last place), so that no closer face is
/// ever skipped.
constexpr double kPruneSlack = 1e-12;

/// The quick distance divides by the squared sine of the angle at a triangle's origin, taken from squares of sides.
/// Down to this value the foot has a relative rounding of about 1e-11. The origin of a thinner triangle is the corner
/// with the largest sine. If that is smaller as well, the foot comes from cross products, whose rounding grows as the
/// inverse of the sine and not of its square. Dimensionless.
constexpr double kLeastSquareSine = 1e-4;

struct ClosestOnFace {
  Bary bary{1, 0, 0};
  double distance = kInfinity;
};

ClosestOnFace closest_on_edge(const std::array<Vec3, 3>& corners, int from, const Vec3& query) {
  const int to = (from + 1) % 3;
  const double t = std::clamp(foot_on_line(corners[from], corners[to], query), 0.0, 1.0);
  ClosestOnFace candidate{{0, 0, 0}, (corners[from] + t * (corners[to] - corners[from]) - query).norm()};
  candidate.bary[from] = 1 - t;
  candidate.bary[to] = t;
  return candidate;
}

/// The foot of the perpendicular if it lies inside the triangle; otherwise a candidate at infinite distance.
ClosestOnFace closest_inside(const std::array<Vec3, 3>& corners, const Vec3& query) {
  const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  const double square = normal.squaredNorm();
  if (!(square > 0)) return {};
  Bary bary;
  for (int i = 0; i < 3; ++i) {
    const Vec3 &b = corners[(i + 1) % 3], &c = corners[(i + 2) % 3];
    bary[i] = (c - b).cross(query - b).dot(normal) / square;
    if (!(bary[i] >= 0)) return {};
  }
  const double sum = bary[0] + bary[1] + bary[2];
  for (double& b : bary) b /= sum;
  return {bary, (interpolate(bary, corners[0], corners[1], corners[2]) - query).norm()};
}

/// A slice of a needle is at least this many times as long as the needle is high. A slice of that shape fills its box
/// well enough. Dimensionless.
constexpr double kLeastSliceLength = 2;
/// Slices are at least this fraction of the mean of the longest sides of all faces, so that the inverse of it times the
/// number of faces bounds the number of slices. Dimensionless.
constexpr double kLeastSliceShare = 0.25;
/// The corners of a slice are computed; a slice's box is larger by this fraction of the largest coordinate of its
/// corners: four units of it, where each coordinate has a rounding of two. Dimensionless.
constexpr double kSliceRounding = 4 * std::numeric_limits<double>::epsilon();

/// A triangle whose longest side is the one from its first corner to its second.
struct LongTriangle {
  std::array<Vec3, 3> corners;
  double length = 0, height = 0;  // of the longest side and above it; mesh units

  explicit LongTriangle(const std::array<Vec3, 3>& from) : corners(from) {
    const auto side = [&](std::size_t k) -> Vec3 { return from[(k + 1) % 3] - from[k]; };
    const std::array<double, 3> square{side(0).squaredNorm(), side(1).squaredNorm(), side(2).squaredNorm()};
    const auto start = std::max_element(square.begin(), square.end()) - square.begin();
    std::rotate(corners.begin(), corners.begin() + start, corners.end());
    length = std::sqrt(square[std::size_t(start)]);
    if (length > 0) height = side(0).cross(side(1)).norm() / length;
  }

  /// The box of the part between two shares of the longest side, across which the triangle is cut.
  Eigen::AlignedBox3d box_between(double from, double to) const {
    const auto& [start, end, apex] = corners;
    const double foot = std::clamp(foot_on_line(start, end, apex), 0.0, 1.0);
    Eigen::AlignedBox3d box;
    for (const double at : {from, to}) {
      box.extend(start + at * (end - start));
      box.extend(at < foot ? Vec3(start + at / foot * (apex - start))
                           : Vec3(end + (foot < 1 ? (1 - at) / (1 - foot) : 0.0) * (apex - end)));
    }
    if (from <= foot && foot <= to) box.extend(apex);
    const double rounding = kSliceRounding * std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
    box.extend(box.min() - Vec3::Constant(rounding));
    box.extend(box.max() + Vec3::Constant(rounding));
    return box;
  }
};

double square_distance_to_box(const Eigen::AlignedBox3d& box, const Vec3& query) {
  return (box.min() - query).cwiseMax(query - box.max()).cwiseMax(0.0).squaredNorm();
}

/// The parameter in [0, 1] of the nearest point of a segment, as the clamped quotient of two scalar products.
double clamp_ratio(double numerator, double denominator) {
  return denominator > 0 ? std::clamp(numerator / denominator, 0.0, 1.0) : 0;
}

}  // namespace

std::vector<FaceId> faces_within(const Mesh& mesh, const SurfacePoint& point, double radius) {
  const Vec3 centre = position(mesh, point);
  const auto distance_to_edge = [&](HalfedgeId h) {
    const Vec3 &from = mesh.position(mesh.from(h)), along = mesh.position(mesh.to(h)) - from;
    return (from + std::clamp(foot_on_edge(mesh, h, centre), 0.0, 1.0) * along - centre).norm();
  };
  std::vector<FaceId> faces = faces_around(mesh, point);
  std::set<FaceId> seen(faces.begin(), faces.end());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (const HalfedgeId h : Mesh::halfedges(faces[i])) {
      const HalfedgeId twin = mesh.twin(h);
      if (!twin.valid() || distance_to_edge(h) > radius) continue;
      if (seen.insert(Mesh::face(twin)).second) faces.push_back(Mesh::face(twin));
    }
  }
  return faces;
}

ClosestPoint closest_point_on_face(const Mesh& mesh, FaceId f, const Vec3& query) {
  const auto& [a, b, c] = mesh.vertices(f);
  const std::array<Vec3, 3> corners{mesh.position(a), mesh.position(b), mesh.position(c)};
  ClosestOnFace best = closest_inside(corners, query);
  for (int i = 0; i < 3; ++i) {
    const ClosestOnFace other = closest_on_edge(corners, i, query);
    if (other.distance < best.distance) best = other;
  }
  return {make_surface_point(f, best.bary), best.distance};
}

/// What the leaves hold: faces and slices, with what sorts them.
class ClosestPointTree::Entries {
 public:
  struct Entry {
    FaceId face;
    std::int32_t slice = -1;  ///< number of a slice's box; -1 for a whole face
  };

  explicit Entries(const Mesh& mesh) : mesh_(mesh), frame_(mesh) {
    double sum = 0;
    for (const FaceId f : mesh.faces()) sum += LongTriangle(corners(f)).length;
    const double least_length = kLeastSliceShare * sum / std::max(mesh.face_count(), 1);
    for (const FaceId f : mesh.faces()) add(f, least_length);
  }

  const BoxFrame& frame() const { return frame_; }
  std::vector<Entry>& order() { return order_; }

  Eigen::AlignedBox3d box(const Entry& entry) const {
    if (entry.slice >= 0) return boxes_[std::size_t(entry.slice)];
    Eigen::AlignedBox3d box;
    for (const Vec3& p : corners(entry.face)) box.extend(p);
    return frame_.widened(box);
  }

  /// Three times the centre.
  double centre(const Entry& entry, Eigen::Index axis) const {
    if (entry.slice < 0) return centres_[entry.face][axis];
    const Eigen::AlignedBox3d& box = boxes_[std::size_t(entry.slice)];
    return 1.5 * (box.min()[axis] + box.max()[axis]);
  }

 private:
  std::array<Vec3, 3> corners(FaceId f) const {
    const auto& [a, b, c] = mesh_.vertices(f);
    return {frame_.turned(mesh_.position(a)), frame_.turned(mesh_.position(b)), frame_.turned(mesh_.position(c))};
  }

  void add(FaceId f, double least_length) {
    const std::array<Vec3, 3> at = corners(f);
    centres_.push_back(3 * at[0] + (at[1] - at[0]) + (at[2] - at[0]));
    const LongTriangle triangle(at);
    const double slice = std::max(kLeastSliceLength * triangle.height, least_length);
    // A length that is not finite, or zero, makes one entry.
    const int count = triangle.length > slice ? int(triangle.length / slice) : 1;
    if (count == 1) return order_.push_back({.face = f});
    for (int i = 0; i < count; ++i) {
      order_.push_back({.face = f, .slice = std::int32_t(boxes_.size())});
      boxes_.push_back(frame_.widened(triangle.box_between(double(i) / count, double(i + 1) / count)));
    }
  }

  const Mesh& mesh_;
  BoxFrame frame_;
  std::vector<Entry> order_;
  IdVector<FaceId, Vec3> centres_;          // three times those of the faces
  std::vector<Eigen::AlignedBox3d> boxes_;  // of the slices
};

ClosestPointTree::ClosestPointTree(const Mesh& mesh) : mesh_(&mesh) {
  Entries entries(mesh);
  is_turned_ = entries.frame().is_turned();
  axes_ = entries.frame().axes();
  const auto count = std::int32_t(entries.order().size());
  if (count > 0) build(0, count, entries);
  place_.resize(std::size_t(mesh.face_count()));
  for (std::int32_t i = 0; i < count; ++i) {
    const FaceId f = entries.order()[std::size_t(i)].face;
    place_[f] = i;
    faces_.push_back(f);
    triangles_.push_back(make_triangle(f));
  }
}

ClosestPointTree::Triangle ClosestPointTree::make_triangle(FaceId f) const {
  const auto& vertices = mesh_->vertices(f);
  Triangle best;
  double largest = 0;  // squared sine so far
  for (std::size_t k = 0; k < 3 && !(largest > kLeastSquareSine); ++k) {
    const Vec3& origin = mesh_->position(vertices[k]);
    const Vec3 u = mesh_->position(vertices[(k + 1) % 3]) - origin, v = mesh_->position(vertices[(k + 2) % 3]) - origin;
    const double uu = u.squaredNorm(), uv = u.dot(v), vv = v.squaredNorm(), determinant = uu * vv - uv * uv;
    const double square_sine = determinant > 0 ? determinant / (uu * vv) : 0;
    if (k > 0 && !(square_sine > largest)) continue;
    best = {origin, u, v, uu, uv, vv, square_sine > kLeastSquareSine ? determinant : 0};
    largest = square_sine;
  }
  return best;
}

void ClosestPointTree::build(std::int32_t first, std::int32_t count, Entries& entries) {
  const std::size_t index = nodes_.size();
  const auto begin = entries.order().begin() + first, end = begin + count;
  Node node;
  for (auto entry = begin; entry != end; ++entry) node.box.extend(entries.box(*entry));
  node.first = first;
  node.count = count <= kLeafFaces ? count : 0;
  nodes_.push_back(node);
  if (node.count > 0) return;
  Eigen::Index axis = 0;
  node.box.sizes().maxCoeff(&axis);
  std::nth_element(begin, begin + count / 2, end, [&](const Entries::Entry& a, const Entries::Entry& b) {
    return std::tuple(entries.centre(a, axis), a.face, a.slice) < std::tuple(entries.centre(b, axis), b.face, b.slice);
  });
  build(first, count / 2, entries);
  nodes_[index].right = static_cast<std::int32_t>(nodes_.size());
  build(first + count / 2, count - count / 2, entries);
}

double ClosestPointTree::square_distance(const Triangle& t, const Vec3& query) {
  const Vec3 to = query - t.origin;
  const double pu = t.u.dot(to), pv = t.v.dot(to);
  double determinant = t.determinant, weight_u = pu * t.vv - pv * t.uv, weight_v = pv * t.uu - pu * t.uv;
  if (!(determinant > 0)) [[unlikely]] {
    const Vec3 normal = t.u.cross(t.v);
    determinant = normal.squaredNorm();
    weight_u = to.cross(t.v).dot(normal);
    weight_v = t.u.cross(to).dot(normal);
  }
  if (weight_u > 0 && weight_v > 0 && weight_u + weight_v < determinant) {
    return (to - (weight_u / determinant) * t.u - (weight_v / determinant) * t.v).squaredNorm();
  }
  double least = kInfinity;
  if (!(weight_v > 0)) least = (to - clamp_ratio(pu, t.uu) * t.u).squaredNorm();
  if (!(weight_u > 0)) least = std::min(least, (to - clamp_ratio(pv, t.vv) * t.v).squaredNorm());
  if (!(weight_u + weight_v < determinant)) {
    const double along = clamp_ratio(pv - pu + t.uu - t.uv, t.uu - 2 * t.uv + t.vv);
    least = std::min(least, (to - t.u - along * (t.v - t.u)).squaredNorm());
  }
  return least;
}

/// The two children of an inner node with the squared distances of their boxes, the nearer child first.
std::array<std::pair<double, std::int32_t>, 2> ClosestPointTree::children(std::int32_t index,
                                                                          const Vec3& turned) const {
  const auto square = [&](std::int32_t child) {
    return std::pair(square_distance_to_box(nodes_[child].box, turned), child);
  };
  std::array<std::pair<double, std::int32_t>, 2> both{square(index + 1), square(nodes_[index].right)};
  if (both[1].first < both[0].first) std::swap(both[0], both[1]);
  return both;
}

/// Looks for a better face below a node, in nearer boxes first. The distance of a NearestFace is squared here, and so
/// is `enough`, which only counts for it.
template <class Best>
void ClosestPointTree::visit(std::int32_t index, const Place& at, double enough, Best& best) const {
  constexpr bool kDecides = std::is_same_v<Best, ClosestPoint>;
  const Node& node = nodes_[index];
  for (std::int32_t i = node.first; i < node.first + node.count; ++i) {
    if constexpr (kDecides) {
      const ClosestPoint found = closest_point_on_face(*mesh_, faces_[i], at.query);
      if (std::tuple(found.distance, found.point.face) < std::tuple(best.distance, best.point.face)) best = found;
    } else {
      const double square = square_distance(triangles_[i], at.query);
      if (square < best.distance) best = {faces_[i], square};
    }
  }
  if (node.count > 0) return;
  for (const auto& [near, child] : children(index, at.turned)) {
    const bool may_hold = kDecides ? std::sqrt(near) <= best.distance * (1 + kPruneSlack)
                                   : near < best.distance && best.distance > enough;
    if (may_hold) visit(child, at, enough, best);
  }
}

NearestFace ClosestPointTree::nearest_face(const Vec3& query, FaceId guess, double enough) const {
  NearestFace best{guess, square_distance(triangle(guess), query)};
  visit(0, {query, is_turned_ ? Vec3(axes_ * query) : query}, enough * enough, best);
  best.distance = std::sqrt(best.distance);
  return best;
}

/// The quick search gives a first bound. Its face need not be the final one.
ClosestPoint ClosestPointTree::query(const Vec3& query) const {
  ClosestPoint best;
  best.distance = kInfinity;
  if (query.allFinite() && !nodes_.empty()) {
    const ClosestPoint guess = closest_point_on_face(*mesh_, nearest_face(query).face, query);
    if (std::isfinite(guess.distance)) best = guess;
    visit(0, {query, is_turned_ ? Vec3(axes_ * query) : query}, 0, best);
  }
  if (!best.point.face.valid()) {
    throw Error(ErrorCode::precondition,
                "a point is too far from the surface for a finite distance; check its coordinates");
  }
  return best;
}

}  // namespace gvd
