#pragma once

#include <vector>

#include "chart_surface.hpp"

namespace gvd {

/// Lays all faces by logarithms, mesh units round their generators. Sets `torn` for those laid by their centre's path.
/// Cost: O(faces crossed) for each vertex and torn face.
std::vector<PlaneCorners> map_by_logarithms(const ChartSurface& surface, IdVector<FaceId, char>& torn);

/// Maps of a disc to the plane, from the best looking to the safest.
inline constexpr int kFlatMaps = 4;

/// The border of an island that is a disc, counter-clockwise.
struct IslandBorder {
  std::vector<VertexId> vertices;
  std::vector<double> side;      ///< length from each vertex to the next one, mesh units
  std::vector<double> distance;  ///< from the generator, mesh units; empty where that is on the boundary
};

/// Cost: O(n), and that of a path for each vertex of the border.
IslandBorder measure_border(const ChartSurface& surface, const Island& island);

/// Lays the faces of an island, a disc, by the `attempt`-th map; false where its border has no such shape. The area is
/// that of the faces, mesh units. Writes to these faces only.
bool map_flat(const Mesh& mesh, const Island& island, const IslandBorder& border, int attempt,
              std::vector<PlaneCorners>& corners);

}  // namespace gvd
