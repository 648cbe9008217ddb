#include "flat_square.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "gvd/lloyd.hpp"

namespace gvd::bench {

Mesh make_flat_square(int n) {
  std::vector<Vec3> positions;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) positions.emplace_back(i, j, 0);
  }
  std::vector<std::array<VertexId, 3>> faces;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = a + n + 1;
      faces.push_back({VertexId(a), VertexId(b), VertexId(c)});
      faces.push_back({VertexId(a), VertexId(c), VertexId(d)});
    }
  }
  return Mesh(std::move(positions), std::move(faces));
}

InteriorEnergy interior_energy(const Mesh& square, int n, const Diagram& diagram, double margin) {
  const IdVector<GeneratorId, CellMoments> moments = compute_cell_moments(square, diagram, 1);
  const double least = margin * n / std::sqrt(static_cast<double>(moments.size()));
  InteriorEnergy interior;
  double area = 0;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const Vec3 p = position(square, diagram.generators[i]);
    if (std::min({p.x(), p.y(), n - p.x(), n - p.y()}) < least) continue;
    const CellMoments& cell = moments[GeneratorId(i)];
    ++interior.cells;
    interior.energy += cell.energy;
    area += cell.area;
  }
  if (area > 0) interior.energy *= interior.cells / (area * area);
  return interior;
}

}  // namespace gvd::bench
