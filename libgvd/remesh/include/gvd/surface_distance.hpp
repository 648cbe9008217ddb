#pragma once

#include "gvd/distance_samples.hpp"
#include "gvd/mesh.hpp"
#include "gvd/progress.hpp"

namespace gvd {

/// Euclidean distances of the points of one surface from another one, mesh units.
struct SurfaceDistance {
  double hausdorff = 0;        ///< the largest distance found; the largest of all is between this and the bound
  double hausdorff_bound = 0;  ///< no point is farther away than this
  double rms = 0;              ///< root of the mean square distance over the surface's area
};

/// The search for the largest distance ends once the bound exceeds the distance found by no more than this fraction of
/// it. Dimensionless.
inline constexpr double kHausdorffTolerance = 0.01;
/// The tolerance for surfaces that agree, as a fraction of the bounding box's diagonal.
inline constexpr double kLeastHausdorffTolerance = 1e-6;

/// Distances of the points of `from` from `to`: one of the two directions.
///
/// Each face of `from` is cut into equal triangles, at least 2^15 in all, or eight for each face of the two meshes if
/// that is less. The RMS sums square distances over these triangles by a rule that is exact for quadratic functions.
///
/// The Hausdorff distance is searched for by branch and bound. The distance from a single face of `to` is a convex
/// function, so on a triangle it is largest at a corner, and that value bounds the distance from `to`. Triangles whose
/// bound exceeds the largest distance found are cut, largest bound first, until none is left or 2^20 and four for each
/// face of `from` have been cut.
///
/// Properties: (1) the result does not depend on `threads` (0: one for each core); (2) it is invariant under rigid
/// motions, up to rounding; (3) `hausdorff` <= the largest distance <= `hausdorff_bound`.
/// Throws Error{precondition} if one of the meshes has no face. Cost: O(n log m) for n triangles and m faces.
SurfaceDistance measure_surface_distance(const Mesh& from, const Mesh& to, int threads = 0,
                                         const Progress& progress = {});

/// The number of equal triangles that sample_surface_distance cuts a surface into, by area.
inline constexpr double kSampledTriangles = 1 << 16;

/// Distances of vertices and points of the faces of `from` from `to`, for pictures.
///
/// A face with the fraction a of the area is cut into k * k triangles, where k is the square root of a *
/// kSampledTriangles, rounded down, at least 1 and at most DistanceSamples::kMaxSteps.
///
/// Properties: (1) the lattices have at most 1.5 * kSampledTriangles points in all, and none if every face is cut into
/// a single triangle, as on a surface of many faces; (2) the result does not depend on `threads` (0: one for each
/// core).
/// Throws Error{precondition} if one of the meshes has no face. Cost: O(n log m) for n samples and m faces.
DistanceSamples sample_surface_distance(const Mesh& from, const Mesh& to, int threads = 0,
                                        const Progress& progress = {});

}  // namespace gvd
