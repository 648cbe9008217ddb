#include "diffusion/heat_field.hpp"

#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>
#include <algorithm>

#include "gvd/error.hpp"

namespace gvd::paper {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Entries = std::vector<Eigen::Triplet<double>>;

/// Faces without area get this height, relative to their longest side: cotangents stay finite.
constexpr double kLeastHeight = 1e-9;

void add_face(const Mesh& mesh, FaceId f, double time, Entries& entries) {
  const auto& length = mesh.shape(f).length;
  const double longest = *std::max_element(length.begin(), length.end());
  const double twice_area = std::max(mesh.shape(f).twice_area, kLeastHeight * longest * longest);
  for (std::size_t i = 0; i < 3; ++i) {
    const int a = mesh.vertices(f)[i].value(), b = mesh.vertices(f)[(i + 1) % 3].value();
    const double own = length[i], left = length[(i + 1) % 3], right = length[(i + 2) % 3];
    const double cotangent = (left * left + right * right - own * own) / (2 * twice_area);
    const double weight = 0.5 * time * cotangent;
    entries.emplace_back(a, a, weight + twice_area / 6);
    entries.emplace_back(b, b, weight);
    entries.emplace_back(a, b, -weight);
    entries.emplace_back(b, a, -weight);
  }
}

/// M + t L, in units of the squared mean edge length, so that the mesh's unit does not matter.
Matrix build_matrix(const Mesh& mesh, double time) {
  Entries entries;
  entries.reserve(static_cast<std::size_t>(12 * mesh.face_count()));
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) add_face(mesh, FaceId(f), time, entries);
  Matrix matrix(mesh.vertex_count(), mesh.vertex_count());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix / (mesh.mean_edge_length() * mesh.mean_edge_length());
}

}  // namespace

HeatField compute_heat(const Mesh& mesh, const std::vector<VertexId>& generators, double time) {
  const Eigen::SimplicialLDLT<Matrix> solver(build_matrix(mesh, time));
  if (solver.info() != Eigen::Success) {
    throw Error(ErrorCode::no_valid_result, "the heat equation's matrix can't be factorised");
  }
  HeatField field;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(mesh.vertex_count());
  for (const VertexId v : generators) {
    right[v.value()] = HeatField::kScale;
    const Eigen::VectorXd heat = solver.solve(right);
    right[v.value()] = 0;
    std::vector<double>& column = field.heat.emplace_back(heat.begin(), heat.end());
    for (double& value : column) value = value > HeatField::kFloor ? value : 0;
  }
  return field;
}

}  // namespace gvd::paper
