#include "distance/nearest_face.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace gvd {
namespace {

constexpr std::int32_t kLeafFaces = 8;

double square_distance_to_box(const Vec3& low, const Vec3& high, const Vec3& point) {
  return (low - point).cwiseMax(point - high).cwiseMax(0.0).squaredNorm();
}

/// The parameter of the point of a segment that is nearest, in [0, 1]: its projection, from the products.
double clamp_ratio(double numerator, double denominator) {
  return denominator > 0 ? std::clamp(numerator / denominator, 0.0, 1.0) : 0;
}

}  // namespace

NearestFaceTree::NearestFaceTree(const Mesh& mesh) {
  for (std::int32_t i = 0; i < mesh.face_count(); ++i) {
    const auto& [a, b, c] = mesh.vertices(FaceId(i));
    Triangle t{mesh.position(a), mesh.position(b) - mesh.position(a), mesh.position(c) - mesh.position(a)};
    t.uu = t.u.squaredNorm();
    t.uv = t.u.dot(t.v);
    t.vv = t.v.squaredNorm();
    triangles_.push_back(t);
    faces_.push_back(FaceId(i));
  }
  if (!faces_.empty()) build(mesh, 0, mesh.face_count());
}

void NearestFaceTree::build(const Mesh& mesh, std::int32_t first, std::int32_t count) {
  const std::size_t index = nodes_.size();
  const auto begin = faces_.begin() + first, end = begin + count;
  Node node;
  node.low.setConstant(std::numeric_limits<double>::infinity());
  node.high = -node.low;
  for (auto f = begin; f != end; ++f) {
    for (const VertexId v : mesh.vertices(*f)) {
      node.low = node.low.cwiseMin(mesh.position(v));
      node.high = node.high.cwiseMax(mesh.position(v));
    }
  }
  node.first = first;
  node.count = count <= kLeafFaces ? count : 0;
  nodes_.push_back(node);
  if (node.count > 0) return;
  Eigen::Index axis = 0;
  (node.high - node.low).maxCoeff(&axis);
  const auto centre = [&](FaceId f) {
    const Triangle& t = triangles_[f];
    return 3 * t.origin[axis] + t.u[axis] + t.v[axis];
  };
  std::nth_element(begin, begin + count / 2, end, [&](FaceId f, FaceId g) {
    const double at_f = centre(f), at_g = centre(g);
    return at_f < at_g || (at_f == at_g && f < g);
  });
  build(mesh, first, count / 2);
  nodes_[index].right = static_cast<std::int32_t>(nodes_.size());
  build(mesh, first + count / 2, count - count / 2);
}

/// Source: C. Ericson, Real-time collision detection, 2005, section 5.1.5: the region of the plane, then the projection.
double NearestFaceTree::square_distance(const Triangle& t, const Vec3& point) {
  const Vec3 to = point - t.origin;
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

double NearestFaceTree::distance(const Vec3& point, FaceId f) const {
  return std::sqrt(square_distance(triangles_[f], point));
}

/// `best.distance` is a square here.
void NearestFaceTree::visit(std::int32_t index, const Vec3& point, NearestFace& best) const {
  const Node& node = nodes_[static_cast<std::size_t>(index)];
  if (node.count > 0) {
    for (std::int32_t i = node.first; i < node.first + node.count; ++i) {
      const FaceId f = faces_[static_cast<std::size_t>(i)];
      const double square = square_distance(triangles_[f], point);
      if (square < best.distance) best = {f, square};
    }
    return;
  }
  const auto square = [&](std::int32_t child) {
    const Node& box = nodes_[static_cast<std::size_t>(child)];
    return std::pair(square_distance_to_box(box.low, box.high, point), child);
  };
  std::array<std::pair<double, std::int32_t>, 2> children{square(index + 1), square(node.right)};
  if (children[1].first < children[0].first) std::swap(children[0], children[1]);
  for (const auto& [near, child] : children) {
    if (near < best.distance) visit(child, point, best);
  }
}

NearestFace NearestFaceTree::find(const Vec3& point, FaceId guess) const {
  NearestFace best{guess, square_distance(triangles_[guess], point)};
  visit(0, point, best);
  best.distance = std::sqrt(best.distance);
  return best;
}

}  // namespace gvd
