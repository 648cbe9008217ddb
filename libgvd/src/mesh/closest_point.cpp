#include "gvd/closest_point.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "base/barycentric.hpp"
#include "gvd/error.hpp"

namespace gvd {
namespace {

constexpr std::int32_t kLeafFaces = 4;
/// A box is skipped if it is farther than the best face by more than this fraction of the distance. Dimensionless. Far
/// above the rounding of the two distances (about ten units in the last place), so that no closer face is ever skipped.
constexpr double kPruneSlack = 1e-12;

struct Candidate {
  Bary bary{1, 0, 0};
  double distance = std::numeric_limits<double>::infinity();
};

void keep_closer(Candidate& best, const Candidate& other) {
  if (other.distance < best.distance) best = other;
}

Candidate closest_on_edge(const std::array<Vec3, 3>& corners, std::size_t from, const Vec3& query) {
  const std::size_t to = (from + 1) % 3;
  const Vec3 along = corners[to] - corners[from];
  const double t = std::clamp(along.dot(query - corners[from]) / along.squaredNorm(), 0.0, 1.0);
  Candidate candidate{{0, 0, 0}, (corners[from] + t * along - query).norm()};
  candidate.bary[from] = 1 - t;
  candidate.bary[to] = t;
  return candidate;
}

/// The foot of the perpendicular if it lies inside the triangle; otherwise a candidate at infinite distance.
Candidate closest_inside(const std::array<Vec3, 3>& corners, const Vec3& query) {
  const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  const double square = normal.squaredNorm();
  Candidate candidate;
  if (!(square > 0)) return candidate;
  Bary bary;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 &b = corners[(i + 1) % 3], &c = corners[(i + 2) % 3];
    bary[i] = (c - b).cross(query - b).dot(normal) / square;
    if (!(bary[i] >= 0)) return candidate;
  }
  const double sum = bary[0] + bary[1] + bary[2];
  for (double& b : bary) b /= sum;
  return {bary, (interpolate(bary, corners[0], corners[1], corners[2]) - query).norm()};
}

double distance_to_box(const Vec3& low, const Vec3& high, const Vec3& query) {
  return (low - query).cwiseMax(query - high).cwiseMax(0.0).norm();
}

}  // namespace

ClosestPoint closest_point_on_face(const Mesh& mesh, FaceId f, const Vec3& query) {
  const auto& [a, b, c] = mesh.vertices(f);
  const std::array<Vec3, 3> corners{mesh.position(a), mesh.position(b), mesh.position(c)};
  Candidate best = closest_inside(corners, query);
  for (std::size_t i = 0; i < 3; ++i) keep_closer(best, closest_on_edge(corners, i, query));
  return {make_surface_point(f, best.bary), best.distance};
}

ClosestPointTree::ClosestPointTree(const Mesh& mesh) : mesh_(&mesh) {
  const std::int32_t count = mesh.face_count();
  std::vector<Vec3> centres;
  for (std::int32_t i = 0; i < count; ++i) {
    const FaceId f(i);
    const auto& [a, b, c] = mesh.vertices(f);
    faces_.push_back(f);
    centres.push_back((mesh.position(a) + mesh.position(b) + mesh.position(c)) / 3);
  }
  if (count > 0) build(0, count, centres);
}

void ClosestPointTree::build(std::int32_t first, std::int32_t count, const std::vector<Vec3>& centres) {
  const std::size_t index = nodes_.size();
  Node node;
  node.first = first;
  node.count = count;
  node.low.setConstant(std::numeric_limits<double>::infinity());
  node.high = -node.low;
  for (std::int32_t i = first; i < first + count; ++i) {
    for (const VertexId v : mesh_->vertices(faces_[static_cast<std::size_t>(i)])) {
      node.low = node.low.cwiseMin(mesh_->position(v));
      node.high = node.high.cwiseMax(mesh_->position(v));
    }
  }
  nodes_.push_back(node);
  if (count <= kLeafFaces) return;
  Eigen::Index axis = 0;
  (node.high - node.low).maxCoeff(&axis);
  const auto begin = faces_.begin() + first;
  std::nth_element(begin, begin + count / 2, begin + count, [&](FaceId f, FaceId g) {
    return std::tuple(centres[f.index()][axis], f) < std::tuple(centres[g.index()][axis], g);
  });
  build(first, count / 2, centres);
  nodes_[index].right = static_cast<std::int32_t>(nodes_.size());
  build(first + count / 2, count - count / 2, centres);
}

void ClosestPointTree::visit(std::int32_t index, const Vec3& query, ClosestPoint& best) const {
  const Node& node = nodes_[static_cast<std::size_t>(index)];
  if (node.right < 0) {
    for (std::int32_t i = node.first; i < node.first + node.count; ++i) {
      const ClosestPoint found = closest_point_on_face(*mesh_, faces_[static_cast<std::size_t>(i)], query);
      if (std::tuple(found.distance, found.point.face) < std::tuple(best.distance, best.point.face)) best = found;
    }
    return;
  }
  const auto distance = [&](std::int32_t child) {
    const Node& box = nodes_[static_cast<std::size_t>(child)];
    return distance_to_box(box.low, box.high, query);
  };
  std::array<std::pair<double, std::int32_t>, 2> children{std::pair{distance(index + 1), index + 1},
                                                          std::pair{distance(node.right), node.right}};
  if (children[1].first < children[0].first) std::swap(children[0], children[1]);
  for (const auto& [near, child] : children) {
    if (near <= best.distance * (1 + kPruneSlack)) visit(child, query, best);
  }
}

ClosestPoint ClosestPointTree::query(const Vec3& query) const {
  ClosestPoint best;
  best.distance = std::numeric_limits<double>::infinity();
  if (query.allFinite() && !nodes_.empty()) visit(0, query, best);
  if (!best.point.face.valid()) {
    throw Error(ErrorCode::precondition,
                "a point is too far from the surface for a finite distance; check its coordinates");
  }
  return best;
}

}  // namespace gvd
