#pragma once

#include <vector>

#include "gvd/coarse_copy.hpp"
#include "gvd/density.hpp"
#include "gvd/error.hpp"
#include "gvd/mesh.hpp"
#include "gvd/progress.hpp"
#include "gvd/sampling.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// Moves a point of the copy to a nearby point of `input`: the closest point in the faces that are near the vertices of
/// the copy's face and connected with them. So the point stays in its component and on its sheet. Cost: O(k log k) for
/// k such faces.
SurfacePoint to_input(const Mesh& input, const CoarseCopy& copy, const SurfacePoint& point);

/// Moves a point of `input` to a nearby point of the copy, by the same rule. Cost: as for `to_input`.
SurfacePoint to_copy(const Mesh& input, const CoarseCopy& copy, const SurfacePoint& point);

/// The same for many points. Reports progress from the beginning of `part` to its end. Throws Error{interrupted} if the
/// callback cancels.
std::vector<SurfacePoint> to_input(const Mesh& input, const CoarseCopy& copy, const std::vector<SurfacePoint>& points,
                                   const Progress& progress, const StepPart& part);
std::vector<SurfacePoint> to_copy(const Mesh& input, const CoarseCopy& copy, const std::vector<SurfacePoint>& points,
                                  const Progress& progress, const StepPart& part);

/// Whether no two points coincide (`find_coincident`).
bool are_apart(const Mesh& mesh, const std::vector<SurfacePoint>& points);

/// Samples generators on the copy and moves them to the input; if two would coincide there, samples on the input
/// itself. Returns the error of `try_to_sample_generators`.
/// Throws Error{interrupted} if the progress callback of the options cancels.
OrError<std::vector<SurfacePoint>> sample_on_copy(const Mesh& input, const CoarseCopy& copy,
                                                  const SamplingOptions& options);

/// The density on the copy: at each vertex, the mean over the part of `input` that collapsed to it. Cost: O(n).
Density to_copy(const Mesh& input, const CoarseCopy& copy, const Density& density);

}  // namespace gvd
