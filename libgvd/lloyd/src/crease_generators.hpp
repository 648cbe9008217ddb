#pragma once

#include <vector>

#include "gvd/lloyd.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// Generators on creases.
struct FeatureGenerators {
  std::vector<SurfacePoint> points;  ///< corners first
  std::vector<Freedom> freedom;      ///< of the points: fixed at corners, on_crease between them
};

/// Puts a generator on each corner (see `trace_creases`), and evenly spaced generators between corners, about `spacing`
/// apart.
///
/// A closed crease without a corner gets at least three generators. `spacing`: mesh units; throws Error{invalid_option}
/// unless it is > 0. Cost: O(n log n).
FeatureGenerators place_on_creases(const Mesh& mesh, const std::vector<EdgeId>& creases, double spacing,
                                   double corner_distance = 0);

/// Moves points within `distance` of a crease onto it: to its nearest vertex within `distance`, or otherwise to the
/// nearest point of its edges. So points written with few digits return to corners and creases. Searches only the faces
/// that contain a point; points at vertices stay. `distance`: mesh units, >= 0. Cost: O(n).
std::vector<SurfacePoint> snap_to_creases(const Mesh& mesh, const std::vector<EdgeId>& creases,
                                          std::vector<SurfacePoint> points, double distance);

/// The freedom of each point by its place: fixed at a corner of a crease, on_crease elsewhere on a crease, otherwise
/// free. Cost: O(n).
std::vector<Freedom> freedoms_on_creases(const Mesh& mesh, const std::vector<EdgeId>& creases,
                                         const std::vector<SurfacePoint>& points);

}  // namespace gvd
