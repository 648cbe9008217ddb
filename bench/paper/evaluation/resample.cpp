#include "resample.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "gvd/closest_point.hpp"
#include "gvd/error.hpp"
#include "gvd/quality.hpp"
#include "refine_flat.hpp"
#include "remesh_isotropic.hpp"

namespace gvd::paper {
namespace {

constexpr int kRemeshRounds = 6;
/// Edges end a little shorter than asked for: measured on kitten, 10k to 60k faces.
constexpr double kEdgeLengthFactor = 1.07;
/// The jitter's step is at most this part of the way to a neighbour.
constexpr double kLongestStep = 0.45;
constexpr double kLeastQ = 0.1;
constexpr double kLeastCosine = 0.5;

using Corners = std::array<VertexId, 3>;

Vec3 normal(const std::vector<Vec3>& positions, const Corners& corners) {
  const auto& [a, b, c] = corners;
  const Vec3& origin = positions[a.index()];
  return (positions[b.index()] - origin).cross(positions[c.index()] - origin);
}

/// The positions of a mesh, moved one by one.
class Jitter {
 public:
  Jitter(const Mesh& mesh, std::uint64_t seed)
      : positions_(mesh.positions()), faces_(positions_.size()), random_(seed) {
    for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
      for (const VertexId v : mesh.vertices(FaceId(f))) faces_[v.index()].push_back(mesh.vertices(FaceId(f)));
    }
  }

  void move_all() {
    for (std::size_t v = 0; v < positions_.size(); ++v) move(v);
  }

  const std::vector<Vec3>& positions() const { return positions_; }

 private:
  /// Not a distribution of the standard library: those differ between platforms.
  double draw() { return static_cast<double>(random_() >> 11) * 0x1p-53; }

  void move(std::size_t v) {
    const Corners& face = faces_[v][random_() % faces_[v].size()];
    const Vec3 target = positions_[face[random_() % 3].index()];
    const Vec3 before = positions_[v];
    std::vector<Vec3> normals;
    for (const Corners& corners : faces_[v]) normals.push_back(normal(positions_, corners));
    positions_[v] += kLongestStep * draw() * (target - before);
    for (std::size_t i = 0; i < normals.size(); ++i) {
      if (!is_allowed(faces_[v][i], normals[i])) positions_[v] = before;
    }
  }

  bool is_allowed(const Corners& corners, const Vec3& normal_before) const {
    const Vec3 now = normal(positions_, corners);
    if (now.dot(normal_before) < kLeastCosine * now.norm() * normal_before.norm()) return false;
    const auto& [a, b, c] = corners;
    return compute_q(positions_[a.index()], positions_[b.index()], positions_[c.index()]) >= kLeastQ;
  }

  std::vector<Vec3> positions_;
  std::vector<std::vector<Corners>> faces_;  ///< per vertex
  std::mt19937_64 random_;
};

std::vector<Corners> list_faces(const Mesh& mesh) {
  std::vector<Corners> faces;
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) faces.push_back(mesh.vertices(FaceId(f)));
  return faces;
}

Mesh make_icosahedron() {
  const double golden = (1 + std::sqrt(5.0)) / 2;
  const double g = golden;
  std::vector<Vec3> positions{{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                              {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  constexpr std::array<std::array<int, 3>, 20> kFaces{{{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                                       {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                                       {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                                       {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}}};
  std::vector<Corners> faces;
  for (const auto& [a, b, c] : kFaces) faces.push_back({VertexId(a), VertexId(b), VertexId(c)});
  return Mesh(std::move(positions), std::move(faces));
}

Mesh push_to_sphere(const Mesh& mesh) {
  std::vector<Vec3> positions = mesh.positions();
  for (Vec3& p : positions) p = p / p.norm();
  return Mesh(std::move(positions), list_faces(mesh));
}

}  // namespace

Mesh resample(const Mesh& mesh, int faces) {
  const MeshSummary summary = compute_mesh_summary(mesh);
  if (summary.boundary_loops > 0) throw Error(ErrorCode::precondition, "only closed meshes are resampled");
  data::Triangles input{mesh.positions(), {}};
  for (const auto& [a, b, c] : list_faces(mesh)) input.faces.push_back({a.value(), b.value(), c.value()});
  const ClosestPointTree tree(mesh);
  const auto project = [&](const Vec3& p) { return position(mesh, tree.query(p).point); };
  const double edge_length = kEdgeLengthFactor * std::sqrt(4 / std::sqrt(3.0) * summary.area / faces);
  const data::Triangles output = data::remesh_isotropic(input, edge_length, kRemeshRounds, project);
  std::vector<Corners> corners;
  for (const auto& [a, b, c] : output.faces) corners.push_back({VertexId(a), VertexId(b), VertexId(c)});
  return Mesh(output.positions, std::move(corners));
}

Mesh jitter(const Mesh& mesh, double percent_below_30, std::uint64_t seed) {
  Jitter jitter(mesh, seed);
  Mesh moved = mesh;
  for (int round = 0; round < kMostJitterRounds; ++round) {
    if (compute_triangle_quality(moved).percent_below_30 >= percent_below_30) break;
    jitter.move_all();
    moved = Mesh(jitter.positions(), list_faces(mesh));
  }
  return moved;
}

Mesh make_icosphere(int subdivisions) {
  Mesh sphere = push_to_sphere(make_icosahedron());
  for (int i = 0; i < subdivisions; ++i) sphere = push_to_sphere(bench::refine_flat(sphere));
  return sphere;
}

}  // namespace gvd::paper
