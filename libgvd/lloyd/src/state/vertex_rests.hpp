#pragma once

#include <optional>
#include <span>
#include <vector>

#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/vec.hpp"
#include "integrals/cell_sums.hpp"

// The energy has kinks at vertices with curvature: the directions of all paths that bend there jump as the generator
// passes the vertex. Where a saddle has a minimum, no gradient vanishes. Steps along gradients would jump from one side
// to the other for ever, and the changes of the gradient would mislead a quasi-Newton method. So generators at vertices
// follow the slopes of the energy there (VertexSlope), and rest where it falls in no direction.

namespace gvd {

/// The generators at vertices, and those beside an inner saddle vertex, within `reach` of it.
WatchedGenerators watch_generators(const Mesh& mesh, const std::vector<SurfacePoint>& generators, double reach);

/// The way in which the energy falls fastest from a generator at a vertex: a tangent vector, of which -2 mass times the
/// length is the slope. Zero where the energy falls in no direction.
/// `paths`: to the points of the generator's cell. Where the vertex is flat, the mean of the log map, `mean`, is the
/// way.
Vec2 steepest_way(const Mesh& mesh, const SurfacePoint& vertex, std::span<const PathSample> paths, double mass,
                  const Vec2& mean);

/// The inner saddle vertex within `reach` that lies on the generator's way, less than 90 degrees off, and where its
/// paths would let it rest: a saddle that holds a generator draws it from all sides. The paths are taken for those from
/// the vertex. The ones that bend there spread evenly over the angle that the vertex has in excess of 360 degrees. For
/// short distances that is nearly so. What holds at the vertex is found out there.
std::optional<VertexId> find_rest(const Mesh& mesh, const SurfacePoint& generator, const Vec2& way, double reach,
                                  std::span<const PathSample> paths);

}  // namespace gvd
