#include "placement/cell_quadrics.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

#include "base/barycentric.hpp"
#include "gvd/surface_point.hpp"
#include "repair/boundary_arcs.hpp"

namespace gvd {

void Quadric::add_plane(const Vec3& normal, const Vec3& through, double weight) {
  matrix += weight * normal * normal.transpose();
  vector += weight * normal.dot(through) * normal;
}

void Quadric::add_line(const Vec3& along, const Vec3& through, double weight) {
  const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - along * along.transpose();
  matrix += weight * across;
  vector += weight * across * through;
}

Vec3 Quadric::minimize(double truncation) const {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrix);
  Vec3 offset(0, 0, 0);
  for (Eigen::Index i = 0; i < 3; ++i) {
    const double value = solver.eigenvalues()[i];
    if (!(value > 0) || value < truncation * solver.eigenvalues()[2]) continue;
    const Vec3 direction = solver.eigenvectors().col(i);
    offset += direction.dot(vector) / value * direction;
  }
  return offset;
}

IdVector<GeneratorId, Quadric> compute_cell_quadrics(const Mesh& mesh, const Diagram& diagram) {
  IdVector<GeneratorId, Quadric> quadrics(diagram.generators.size());
  IdVector<GeneratorId, Vec3> origin;
  for (const SurfacePoint& p : diagram.generators) origin.push_back(position(mesh, p));
  const auto add_face = [&](FaceId f, GeneratorId g, double area) {
    quadrics[g].add_plane(face_normal(mesh, f), mesh.position(mesh.vertices(f)[0]) - origin[g], area);
    quadrics[g].area += area;
  };
  for (std::int32_t i = 0; i < mesh.face_count(); ++i) {
    const FaceId f(i);
    if (diagram.face_label[f].valid()) add_face(f, diagram.face_label[f], mesh.area(f));
  }
  for (const FacePiece& piece : diagram.pieces) {
    add_face(piece.face, piece.generator, std::max(0.0, area_share(piece.corners)) * mesh.area(piece.face));
  }
  for (const BoundaryArc& arc : list_boundary_arcs(mesh, diagram)) {
    Quadric& quadric = quadrics[arc.cell];
    for (const BoundaryArc::Segment& segment : arc.segments) {
      const Vec3 from = mesh.position(mesh.from(segment.halfedge)),
                 edge = mesh.position(mesh.to(segment.halfedge)) - from;
      const double length = (segment.end - segment.begin) * edge.norm();
      quadric.add_line(edge.normalized(), from - origin[arc.cell], length * std::sqrt(quadric.area));
    }
  }
  return quadrics;
}

}  // namespace gvd
