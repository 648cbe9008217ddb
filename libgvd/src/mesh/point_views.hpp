#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// A point on an edge, in the coordinates of the face on the other side; nothing on the boundary. The weights of the
/// two corners are the same numbers.
std::optional<SurfacePoint> find_view_across(const Mesh& mesh, const SurfacePoint& point);

/// The same point seen from every face that contains it: one for a point inside a face, at most two on an edge, the
/// whole fan at a vertex. Ascending by face. Cost: O(valence).
std::vector<SurfacePoint> find_views(const Mesh& mesh, const SurfacePoint& point);

/// Two points seen from a face that contains both, the one with the least id; nothing where there is none.
std::optional<std::pair<SurfacePoint, SurfacePoint>> find_common_view(const Mesh& mesh, const SurfacePoint& a,
                                                                      const SurfacePoint& b);

}  // namespace gvd
