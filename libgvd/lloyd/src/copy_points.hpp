#pragma once

#include <vector>

#include "gvd/coarse_copy.hpp"
#include "gvd/density.hpp"
#include "gvd/mesh.hpp"
#include "gvd/progress.hpp"
#include "gvd/sampling.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// The point of `input` near a point of the copy: the closest one among the faces within the reach of the copy's face,
/// connected with its vertices. So it stays in its component and on its sheet. Cost: O(k log k) for k such faces.
SurfacePoint to_input(const Mesh& input, const CoarseCopy& copy, const SurfacePoint& point);

/// The point of the copy near a point of `input`, by the same rule. Cost: as `to_input`.
SurfacePoint to_copy(const Mesh& input, const CoarseCopy& copy, const SurfacePoint& point);

/// The same for many points. The progress goes from the beginning of the part to its end. Throws Error{interrupted} if
/// the callback cancels.
std::vector<SurfacePoint> to_input(const Mesh& input, const CoarseCopy& copy, const std::vector<SurfacePoint>& points,
                                   const Progress& progress, const StepPart& part);
std::vector<SurfacePoint> to_copy(const Mesh& input, const CoarseCopy& copy, const std::vector<SurfacePoint>& points,
                                  const Progress& progress, const StepPart& part);

/// Whether no two of the points coincide (find_coincident).
bool are_apart(const Mesh& mesh, const std::vector<SurfacePoint>& points);

/// `sample_generators` on the copy, each point moved to the input; on the input itself where two would coincide.
/// Throws Error{interrupted} if the progress callback of the options cancels.
std::vector<SurfacePoint> sample_on_copy(const Mesh& input, const CoarseCopy& copy, const SamplingOptions& options);

/// The density on the copy: at a vertex the mean over the part of `input` that collapsed to it. Cost: O(n).
Density to_copy(const Mesh& input, const CoarseCopy& copy, const Density& density);

}  // namespace gvd
