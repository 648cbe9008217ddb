#include "jitter.hpp"

#include <array>
#include <random>
#include <utility>
#include <vector>

#include "gvd/quality.hpp"
#include "list_faces.hpp"

namespace gvd::paper {
namespace {

/// The jitter's step is at most this part of the way to a neighbour.
constexpr double kLongestStep = 0.45;
constexpr double kLeastQ = 0.1;
constexpr double kLeastCosine = 0.5;

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

}  // namespace

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

}  // namespace gvd::paper
