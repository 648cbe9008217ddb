// Energy and centroid of a cell, in closed form over the triangles of its faces and clipped faces.
#include "cell_integrals.hpp"

#include <algorithm>

#include "base/barycentric.hpp"

namespace gvd {
namespace {

constexpr std::array<Bary, 3> kWholeFace{Bary{1, 0, 0}, Bary{0, 1, 0}, Bary{0, 0, 1}};

Bary middle(const Bary& p, const Bary& q) { return {0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1]), 0.5 * (p[2] + q[2])}; }

/// Signed area of a triangle given in barycentric coordinates, as a fraction of its face's area.
double area_fraction(const Bary& p, const Bary& q, const Bary& r) {
  return twice_signed_area(affine_point(p), affine_point(q), affine_point(r));
}

}  // namespace

const Density CellIntegrals::kUniform;

double SquaredDistance::at(const std::array<double, 3>& b) const {
  const double linear = interpolate(b, corner[0], corner[1], corner[2]);
  const double quadratic = b[0] * b[1] * side[0] + b[1] * b[2] * side[1] + b[2] * b[0] * side[2];
  return std::max(0.0, linear - quadratic);
}

CellMoments CellIntegrals::compute(const SurfacePoint& generator, std::span<const CellFace> cell) {
  faces_.clear();
  for (const CellFace& face : cell) faces_.push_back(face.face);
  std::sort(faces_.begin(), faces_.end());
  faces_.erase(std::unique(faces_.begin(), faces_.end()), faces_.end());
  LogMap map = solver_.compute(generator, faces_);
  if (!map.complete) {
    for (std::int32_t f = faces_.empty() ? mesh_.face_count() : 0; f < mesh_.face_count(); ++f) faces_.emplace_back(f);
    std::sort(faces_.begin(), faces_.end());
    faces_.erase(std::unique(faces_.begin(), faces_.end()), faces_.end());
    map = solver_.compute(generator, faces_);
  }
  CellMoments sum;
  for (const CellFace& face : cell) {
    const auto at = std::lower_bound(faces_.begin(), faces_.end(), face.face) - faces_.begin();
    add(face, map.corners[static_cast<std::size_t>(at)], sum);
  }
  if (sum.mass > 0) sum.centroid /= sum.mass;
  return sum;
}

/// The integral over a simple polygon is the signed sum over the triangles of a fan. The quadrature rule of the three
/// edge midpoints is exact for quadratic functions.
void CellIntegrals::add(const CellFace& face, const std::array<Vec2, 3>& log, CellMoments& sum) const {
  const std::span<const Bary> polygon = face.piece ? std::span<const Bary>(face.piece->corners) : kWholeFace;
  const double face_area = mesh_.area(face.face);
  SquaredDistance squared{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double length = mesh_.length(Mesh::halfedge(face.face, static_cast<int>(i)));
    squared.corner[i] = log[i].squaredNorm();
    squared.side[i] = length * length;
  }
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const Bary &p = polygon[0], &q = polygon[i], &r = polygon[i + 1];
    const double third = face_area * area_fraction(p, q, r) / 3;
    sum.area += 3 * third;
    for (const Bary& at : {middle(p, q), middle(q, r), middle(r, p)}) {
      const double mass = third * density_.at(face.face, at);
      sum.mass += mass;
      sum.energy += mass * squared.at(at);
      sum.centroid += mass * interpolate(at, log[0], log[1], log[2]);
    }
  }
}

}  // namespace gvd
