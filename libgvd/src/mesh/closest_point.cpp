// Finds the point of a surface that is closest to a point in space.
//
// The search uses a tree of bounding boxes, which halves the faces at the median of their centres along the longest
// axis of their box. Its leaves have at most four faces. A search visits the nearer box first, with the nearest face as
// a first bound.
// Source: C. Ericson, Real-time collision detection, 2005, section 5.1.5, for the tree's quick distance from a
// triangle: first the region of the plane, then the projection. `closest_point_on_face` is slower, and has the last
// word.
// Invariant: `query` skips a box only if it is farther away than the best face by more than rounding. So the result
// does not depend on the shape of the tree: the least distance wins, and among equal distances the face with the
// smallest id.
#include "gvd/closest_point.hpp"

#include <algorithm>
#include <set>
#include <tuple>
#include <type_traits>

#include "base/barycentric.hpp"
#include "gvd/error.hpp"

namespace gvd {
namespace {

constexpr std::int32_t kLeafFaces = 4;
/// A box is skipped if it is farther away than the best face by more than this fraction of the distance. Dimensionless.
/// It is far above the rounding of the two distances (about ten units in the last place), so that no closer face is
/// ever skipped.
constexpr double kPruneSlack = 1e-12;

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

ClosestPointTree::ClosestPointTree(const Mesh& mesh) : mesh_(&mesh) {
  std::vector<Vec3> centres;  // three times the centre of each face
  for (const FaceId f : mesh.faces()) {
    const Triangle t = make_triangle(f);
    centres.push_back(3 * t.origin + t.u + t.v);
    faces_.push_back(f);
  }
  if (!faces_.empty()) build(0, mesh.face_count(), centres);
  place_.resize(faces_.size());
  for (std::int32_t i = 0; i < mesh.face_count(); ++i) {
    place_[faces_[i]] = i;
    triangles_.push_back(make_triangle(faces_[i]));
  }
}

ClosestPointTree::Triangle ClosestPointTree::make_triangle(FaceId f) const {
  const auto& [a, b, c] = mesh_->vertices(f);
  const Vec3& origin = mesh_->position(a);
  const Vec3 u = mesh_->position(b) - origin, v = mesh_->position(c) - origin;
  return {origin, u, v, u.squaredNorm(), u.dot(v), v.squaredNorm()};
}

void ClosestPointTree::build(std::int32_t first, std::int32_t count, const std::vector<Vec3>& centres) {
  const std::size_t index = nodes_.size();
  const auto begin = faces_.begin() + first, end = begin + count;
  Node node;
  for (auto f = begin; f != end; ++f) {
    for (const VertexId v : mesh_->vertices(*f)) node.box.extend(mesh_->position(v));
  }
  node.first = first;
  node.count = count <= kLeafFaces ? count : 0;
  nodes_.push_back(node);
  if (node.count > 0) return;
  Eigen::Index axis = 0;
  node.box.sizes().maxCoeff(&axis);
  std::nth_element(begin, begin + count / 2, end, [&](FaceId f, FaceId g) {
    const double at_f = centres[f.index()][axis], at_g = centres[g.index()][axis];
    return at_f < at_g || (at_f == at_g && f < g);
  });
  build(first, count / 2, centres);
  nodes_[index].right = static_cast<std::int32_t>(nodes_.size());
  build(first + count / 2, count - count / 2, centres);
}

double ClosestPointTree::square_distance(const Triangle& t, const Vec3& query) {
  const Vec3 to = query - t.origin;
  const double pu = t.u.dot(to), pv = t.v.dot(to);
  const double determinant = t.uu * t.vv - t.uv * t.uv;
  const double weight_u = pu * t.vv - pv * t.uv, weight_v = pv * t.uu - pu * t.uv;
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
std::array<std::pair<double, std::int32_t>, 2> ClosestPointTree::children(std::int32_t index, const Vec3& query) const {
  const auto square = [&](std::int32_t child) {
    return std::pair(square_distance_to_box(nodes_[child].box, query), child);
  };
  std::array<std::pair<double, std::int32_t>, 2> both{square(index + 1), square(nodes_[index].right)};
  if (both[1].first < both[0].first) std::swap(both[0], both[1]);
  return both;
}

/// Looks for a better face below a node, in nearer boxes first. The distance of a NearestFace is squared here, and so
/// is `enough`, which only counts for it.
template <class Best>
void ClosestPointTree::visit(std::int32_t index, const Vec3& query, double enough, Best& best) const {
  constexpr bool kDecides = std::is_same_v<Best, ClosestPoint>;
  const Node& node = nodes_[index];
  for (std::int32_t i = node.first; i < node.first + node.count; ++i) {
    if constexpr (kDecides) {
      const ClosestPoint found = closest_point_on_face(*mesh_, faces_[i], query);
      if (std::tuple(found.distance, found.point.face) < std::tuple(best.distance, best.point.face)) best = found;
    } else {
      const double square = square_distance(triangles_[i], query);
      if (square < best.distance) best = {faces_[i], square};
    }
  }
  if (node.count > 0) return;
  for (const auto& [near, child] : children(index, query)) {
    const bool may_hold = kDecides ? std::sqrt(near) <= best.distance * (1 + kPruneSlack)
                                   : near < best.distance && best.distance > enough;
    if (may_hold) visit(child, query, enough, best);
  }
}

NearestFace ClosestPointTree::nearest_face(const Vec3& query, FaceId guess, double enough) const {
  NearestFace best{guess, square_distance(triangle(guess), query)};
  visit(0, query, enough * enough, best);
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
    visit(0, query, 0, best);
  }
  if (!best.point.face.valid()) {
    throw Error(ErrorCode::precondition,
                "a point is too far from the surface for a finite distance; check its coordinates");
  }
  return best;
}

}  // namespace gvd
