#include "resample.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "gvd/closest_point.hpp"
#include "gvd/error.hpp"
#include "list_faces.hpp"
#include "remesh_isotropic.hpp"

namespace gvd::paper {
namespace {

constexpr int kRemeshRounds = 6;
/// Edges end a little shorter than asked for: measured on kitten, 10k to 60k faces.
constexpr double kEdgeLengthFactor = 1.07;

/// What a try found: logarithms of the edge length and of the number of faces over the wanted one.
struct Try {
  double length = 0;
  double excess = 0;
};

/// The next length to try. Between a try with too many faces and one with too few, the line through both says; else as
/// if the number went with the square of the length.
double predict_length(const Try& last, const std::optional<Try>& many, const std::optional<Try>& few) {
  if (!many || !few) return last.length + 0.5 * last.excess;
  const double share = many->excess / (many->excess - few->excess);
  return many->length + std::clamp(share, 0.1, 0.9) * (few->length - many->length);
}

}  // namespace

Mesh search_edge_length(const Remesher& remesh, double area, int faces) {
  double length = std::log(kEdgeLengthFactor * std::sqrt(4 / std::sqrt(3.0) * area / faces));
  std::optional<Try> many, few;
  std::optional<Mesh> nearest;
  double least = 0;
  for (int i = 0; i < kMostTries; ++i) {
    Mesh mesh = remesh(std::exp(length));
    const double excess = std::log(static_cast<double>(mesh.face_count()) / faces);
    if (!nearest || std::abs(excess) < least) {
      least = std::abs(excess);
      nearest = std::move(mesh);
    }
    if (std::abs(nearest->face_count() - faces) <= kFacesTolerance * faces) break;
    const Try last{length, excess};
    (excess > 0 ? many : few) = last;
    length = predict_length(last, many, few);
  }
  return *std::move(nearest);
}

Mesh resample(const Mesh& mesh, int faces) {
  const MeshSummary summary = compute_mesh_summary(mesh);
  if (summary.boundary_loops > 0) throw Error(ErrorCode::precondition, "only closed meshes are resampled");
  data::Triangles input{mesh.positions(), {}};
  for (const auto& [a, b, c] : list_faces(mesh)) input.faces.push_back({a.value(), b.value(), c.value()});
  const ClosestPointTree tree(mesh);
  const auto project = [&](const Vec3& p) { return position(mesh, tree.query(p).point); };
  const auto remesh = [&](double edge_length) {
    const data::Triangles output = data::remesh_isotropic(input, edge_length, kRemeshRounds, project);
    std::vector<Corners> corners;
    for (const auto& [a, b, c] : output.faces) corners.push_back({VertexId(a), VertexId(b), VertexId(c)});
    return Mesh(output.positions, std::move(corners));
  };
  return search_edge_length(remesh, summary.area, faces);
}

}  // namespace gvd::paper
