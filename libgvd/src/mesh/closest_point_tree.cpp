#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "gvd/closest_point.hpp"
#include "gvd/error.hpp"

namespace gvd {
namespace {

constexpr std::int32_t kLeafFaces = 4;
/// A box is skipped if it is farther than the best face by more than this fraction of the distance. Dimensionless. Far
/// above the rounding of the two distances (about ten units in the last place), so that no closer face is ever skipped.
constexpr double kPruneSlack = 1e-12;

double square_distance_to_box(const Vec3& low, const Vec3& high, const Vec3& query) {
  return (low - query).cwiseMax(query - high).cwiseMax(0.0).squaredNorm();
}

/// The parameter of the point of a segment that is nearest, in [0, 1]: its projection, from the products.
double clamp_ratio(double numerator, double denominator) {
  return denominator > 0 ? std::clamp(numerator / denominator, 0.0, 1.0) : 0;
}

}  // namespace

ClosestPointTree::ClosestPointTree(const Mesh& mesh) : mesh_(&mesh) {
  std::vector<Vec3> centres;  // times three
  for (std::int32_t i = 0; i < mesh.face_count(); ++i) {
    const Triangle t = make_triangle(FaceId(i));
    centres.push_back(3 * t.origin + t.u + t.v);
    faces_.push_back(FaceId(i));
  }
  if (!faces_.empty()) build(0, mesh.face_count(), centres);
  place_.resize(faces_.size());
  for (const FaceId f : faces_) {
    place_[f] = static_cast<std::int32_t>(triangles_.size());
    triangles_.push_back(make_triangle(f));
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
  node.low.setConstant(std::numeric_limits<double>::infinity());
  node.high = -node.low;
  for (auto f = begin; f != end; ++f) {
    for (const VertexId v : mesh_->vertices(*f)) {
      node.low = node.low.cwiseMin(mesh_->position(v));
      node.high = node.high.cwiseMax(mesh_->position(v));
    }
  }
  node.first = first;
  node.count = count <= kLeafFaces ? count : 0;
  nodes_.push_back(node);
  if (node.count > 0) return;
  Eigen::Index axis = 0;
  (node.high - node.low).maxCoeff(&axis);
  std::nth_element(begin, begin + count / 2, end, [&](FaceId f, FaceId g) {
    const double at_f = centres[f.index()][axis], at_g = centres[g.index()][axis];
    return at_f < at_g || (at_f == at_g && f < g);
  });
  build(first, count / 2, centres);
  nodes_[index].right = static_cast<std::int32_t>(nodes_.size());
  build(first + count / 2, count - count / 2, centres);
}

/// Source: C. Ericson, Real-time collision detection, 2005, section 5.1.5: the region of the plane, then the projection.
double ClosestPointTree::square_distance(const Triangle& t, const Vec3& query) {
  const Vec3 to = query - t.origin;
  const double pu = t.u.dot(to), pv = t.v.dot(to);
  const double determinant = t.uu * t.vv - t.uv * t.uv;
  const double weight_u = pu * t.vv - pv * t.uv, weight_v = pv * t.uu - pu * t.uv;
  if (weight_u > 0 && weight_v > 0 && weight_u + weight_v < determinant) {
    return (to - (weight_u / determinant) * t.u - (weight_v / determinant) * t.v).squaredNorm();
  }
  double least = std::numeric_limits<double>::infinity();
  if (!(weight_v > 0)) least = (to - clamp_ratio(pu, t.uu) * t.u).squaredNorm();
  if (!(weight_u > 0)) least = std::min(least, (to - clamp_ratio(pv, t.vv) * t.v).squaredNorm());
  if (!(weight_u + weight_v < determinant)) {
    const double along = clamp_ratio(pv - pu + t.uu - t.uv, t.uu - 2 * t.uv + t.vv);
    least = std::min(least, (to - t.u - along * (t.v - t.u)).squaredNorm());
  }
  return least;
}

double ClosestPointTree::distance(const Vec3& query, FaceId f) const {
  return std::sqrt(square_distance(triangle(f), query));
}

/// The two children of an inner node by the square distances of their boxes, the nearer first.
std::array<std::pair<double, std::int32_t>, 2> ClosestPointTree::children(std::int32_t index, const Vec3& query) const {
  const auto square = [&](std::int32_t child) {
    const Node& box = nodes_[child];
    return std::pair(square_distance_to_box(box.low, box.high, query), child);
  };
  std::array<std::pair<double, std::int32_t>, 2> both{square(index + 1), square(nodes_[index].right)};
  if (both[1].first < both[0].first) std::swap(both[0], both[1]);
  return both;
}

/// `best.distance` is a square here.
void ClosestPointTree::visit(std::int32_t index, const Vec3& query, NearestFace& best) const {
  const Node& node = nodes_[index];
  for (std::int32_t i = node.first; i < node.first + node.count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double square = square_distance(triangles_[at], query);
    if (square < best.distance) best = {faces_[at], square};
  }
  if (node.count > 0) return;
  for (const auto& [near, child] : children(index, query)) {
    if (near < best.distance) visit(child, query, best);
  }
}

NearestFace ClosestPointTree::nearest_face(const Vec3& query, FaceId guess) const {
  NearestFace best{guess, square_distance(triangle(guess), query)};
  visit(0, query, best);
  best.distance = std::sqrt(best.distance);
  return best;
}

void ClosestPointTree::visit(std::int32_t index, const Vec3& query, ClosestPoint& best) const {
  const Node& node = nodes_[index];
  for (std::int32_t i = node.first; i < node.first + node.count; ++i) {
    const ClosestPoint found = closest_point_on_face(*mesh_, faces_[i], query);
    if (std::tuple(found.distance, found.point.face) < std::tuple(best.distance, best.point.face)) best = found;
  }
  if (node.count > 0) return;
  for (const auto& [near, child] : children(index, query)) {
    if (std::sqrt(near) <= best.distance * (1 + kPruneSlack)) visit(child, query, best);
  }
}

/// The nearest face bounds the search from the start; it may not be the one that wins.
ClosestPoint ClosestPointTree::query(const Vec3& query) const {
  ClosestPoint best;
  best.distance = std::numeric_limits<double>::infinity();
  if (query.allFinite() && !nodes_.empty()) {
    const ClosestPoint near = closest_point_on_face(*mesh_, nearest_face(query).face, query);
    if (std::isfinite(near.distance)) best = near;
    visit(0, query, best);
  }
  if (!best.point.face.valid()) {
    throw Error(ErrorCode::precondition,
                "a point is too far from the surface for a finite distance; check its coordinates");
  }
  return best;
}

}  // namespace gvd
