#pragma once

#include <vector>

#include "gvd/features.hpp"

namespace gvd {

/// Generators on the creases.
struct FeatureGenerators {
  std::vector<SurfacePoint> points;  ///< corners first
  std::vector<Freedom> freedom;      ///< of the points: fixed at corners, on_crease between them
};

/// Puts a generator on each corner, and along each crease between two corners as many as keep about this distance.
///
/// Corners are those of trace_creases, with `corner_distance`. A closed crease without a corner has at least three
/// generators. Those between corners are evenly spaced by length.
/// `spacing`: mesh units, > 0. Throws Error{invalid_option} if it is not. Cost: O(n log n).
FeatureGenerators place_on_creases(const Mesh& mesh, const std::vector<EdgeId>& creases, double spacing,
                                   double corner_distance = 0);

/// The points, those within `distance` of a crease moved onto it: to its nearest vertex within `distance`, else to the
/// nearest point of its edges. So points that were written with few digits are at corners and on creases again. Only
/// the faces that contain a point are searched, and vertices stay. `distance`: mesh units, >= 0. Cost: O(n).
std::vector<SurfacePoint> snap_to_creases(const Mesh& mesh, const std::vector<EdgeId>& creases,
                                          std::vector<SurfacePoint> points, double distance);

/// The freedom of each point, by where it lies: fixed at a corner of a crease, on_crease beside it on the crease,
/// free elsewhere. Cost: O(n).
std::vector<Freedom> freedoms_on_creases(const Mesh& mesh, const std::vector<EdgeId>& creases,
                                         const std::vector<SurfacePoint>& points);

}  // namespace gvd
