#include "io/view/cell_energy.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gvd::io {
namespace {

using Bary = std::array<double, 3>;

/// The squared distance in one face, as a function of barycentric coordinates.
class SquaredDistance {
 public:
  SquaredDistance(const Mesh& mesh, const Diagram& diagram, FaceId f) {
    const auto& corners = mesh.vertices(f);
    for (std::size_t i = 0; i < 3; ++i) {
      corner_[i] = std::pow(diagram.vertex_distance[corners[i]], 2);
      side_[i] = (mesh.position(corners[(i + 1) % 3]) - mesh.position(corners[i])).squaredNorm();
    }
  }

  double operator()(const Bary& b) const {
    const double value = b[0] * corner_[0] + b[1] * corner_[1] + b[2] * corner_[2] -
                         (b[0] * b[1] * side_[0] + b[1] * b[2] * side_[1] + b[2] * b[0] * side_[2]);
    return value > 0 ? value : 0;
  }

 private:
  Bary corner_{}, side_{};
};

Bary middle(const Bary& a, const Bary& b) { return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2}; }

/// Integral over a polygon of a face of area `area`: a fan of triangles with signed areas, each by the midpoints of its
/// sides, which is exact for quadratic functions.
double integrate(const SquaredDistance& squared, double area, const std::vector<Bary>& polygon) {
  double sum = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const Bary &a = polygon[0], &b = polygon[i - 1], &c = polygon[i];
    const double share = (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]);
    sum += area * share * (squared(middle(a, b)) + squared(middle(b, c)) + squared(middle(c, a))) / 3;
  }
  return sum;
}

}  // namespace

IdVector<GeneratorId, double> compute_cell_energies(const Mesh& mesh, const Diagram& diagram) {
  IdVector<GeneratorId, double> energies(diagram.cells.size(), 0.0);
  const auto add = [&](FaceId f, GeneratorId cell, const std::vector<Bary>& polygon) {
    const double energy = integrate(SquaredDistance(mesh, diagram, f), mesh.area(f), polygon);
    if (std::isfinite(energy)) energies[cell] += energy;
  };
  const std::vector<Bary> whole{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (std::size_t i = 0; i < diagram.face_label.size(); ++i) {
    const FaceId f(i);
    if (diagram.face_label[f].valid()) add(f, diagram.face_label[f], whole);
  }
  for (const FacePiece& piece : diagram.pieces) add(piece.face, piece.generator, piece.corners);
  return energies;
}

}  // namespace gvd::io
