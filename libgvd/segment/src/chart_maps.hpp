#pragma once

#include <vector>

#include "chart_surface.hpp"

namespace gvd {

/// Places all faces by logarithms, in mesh units around their generators. Sets `torn` for faces placed by the path to
/// their centre. Cost: O(faces crossed) for each vertex and torn face.
std::vector<PlaneCorners> map_by_logarithms(const ChartSurface& surface, IdVector<FaceId, char>& torn);

/// Number of maps of a disc to the plane, from the best looking to the safest.
inline constexpr int kFlatMaps = 4;

/// The border of an island that is a disc, counter-clockwise.
struct IslandBorder {
  std::vector<VertexId> vertices;
  std::vector<double> side;      ///< length from each vertex to the next, mesh units
  std::vector<double> distance;  ///< from the generator, mesh units; empty if the generator is on the boundary
};

/// Measures the border of an island. Cost: O(n), and a path for each vertex of the border.
IslandBorder measure_border(const ChartSurface& surface, const Island& island);

/// Maps the faces of an island, which must be a disc, by the `attempt`-th map, with the faces' area in mesh units.
/// Returns false if the border can't be placed in this way. Writes only the corners of these faces.
bool map_flat(const Mesh& mesh, const Island& island, const IslandBorder& border, int attempt,
              std::vector<PlaneCorners>& corners);

}  // namespace gvd
