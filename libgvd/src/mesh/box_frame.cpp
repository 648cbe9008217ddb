// Whether boxes follow the principal axes is decided by the sum of the boxes' areas, which is what a search pays for.
// Source: for areas of boxes as a cost, J. Goldsmith and J. Salmon, Automatic creation of object hierarchies for ray
// tracing, 1987.
#include "mesh/box_frame.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>

namespace gvd {
namespace {

/// Boxes follow the principal axes if they then have less than this fraction of their area, added up. Dimensionless.
constexpr double kWorthTurning = 0.5;
/// A box of turned corners is larger by this fraction of the largest norm of a vertex. Three products and their sum
/// round by 1.5 units of it, and so does a query. Dimensionless.
constexpr double kTurnRounding = 8 * std::numeric_limits<double>::epsilon();

/// The sum of the areas of the faces' boxes, up to a factor.
double box_area(const Mesh& mesh, const Eigen::Matrix3d& axes) {
  double sum = 0;
  for (const FaceId f : mesh.faces()) {
    Eigen::AlignedBox3d box;
    for (const VertexId v : mesh.vertices(f)) box.extend(Vec3(axes * mesh.position(v)));
    const Vec3 size = box.sizes();
    sum += size.x() * size.y() + size.y() * size.z() + size.z() * size.x();
  }
  return sum;
}

/// The axes along which the vertices spread most and least, as rows. Not finite where squares of lengths overflow.
Eigen::Matrix3d principal_axes(const Mesh& mesh) {
  Vec3 centre = Vec3::Zero();
  for (const Vec3& p : mesh.positions()) centre += p / mesh.vertex_count();
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vec3& p : mesh.positions()) spread += (p - centre) * (p - centre).transpose();
  if (!spread.allFinite()) return Eigen::Matrix3d::Constant(std::numeric_limits<double>::infinity());
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().transpose();
}

}  // namespace

BoxFrame::BoxFrame(const Mesh& mesh) {
  const Eigen::Matrix3d principal = principal_axes(mesh);
  if (!principal.allFinite() || !(box_area(mesh, principal) < kWorthTurning * box_area(mesh, axes_))) return;
  axes_ = principal;
  for (const Vec3& p : mesh.positions()) rounding_ = std::max(rounding_, kTurnRounding * p.norm());
}

Eigen::AlignedBox3d BoxFrame::widened(const Eigen::AlignedBox3d& box) const {
  if (!is_turned()) return box;
  return {box.min().array() - rounding_, box.max().array() + rounding_};
}

Eigen::AlignedBox3d BoxFrame::box(std::span<const Vec3> points) const {
  Eigen::AlignedBox3d box;
  for (const Vec3& p : points) box.extend(turned(p));
  return widened(box);
}

}  // namespace gvd
