#include "rvd/euclidean_cells.hpp"

#include <utility>

namespace gvd::paper {

LinearForm EuclideanCells::bisector_form(FaceId f, GeneratorId a, GeneratorId b) const {
  const Vec3 &p = positions_[a.index()], &q = positions_[b.index()];
  const Vec3 normal = p - q, twice_middle = p + q;
  LinearForm form{};
  for (std::size_t i = 0; i < 3; ++i) form[i] = normal.dot(2 * mesh_.position(mesh_.vertices(f)[i]) - twice_middle);
  return form;
}

Polygon EuclideanCells::clip(FaceId f, Polygon polygon, GeneratorId g, std::span<const GeneratorId> others) const {
  for (const GeneratorId other : others) {
    if (other == g) continue;
    polygon = clip_polygon(polygon, bisector_form(f, g, other), g < other);
    if (polygon.empty()) break;
  }
  return polygon;
}

}  // namespace gvd::paper
