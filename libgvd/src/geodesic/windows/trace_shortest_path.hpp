#pragma once

#include <vector>

#include "geodesic/windows/field/window_field.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// A shortest path from a point back to its nearest generator.
struct ShortestPath {
  std::vector<SurfacePoint> points;  ///< from the point to the generator; consecutive points share a face
  GeneratorId generator;             ///< invalid where none reaches
  double distance = 0;               ///< mesh units; infinity where none reaches
  bool complete = false;             ///< whether the points lead to the generator, and do not end at a vertex before
};

/// Traces the path over edges and pseudo-sources. All windows must have been kept.
/// `generators` are the vertices that the field was propagated from. Cost: O(faces crossed + windows at its ends).
ShortestPath trace_shortest_path(const Mesh& mesh, const WindowField& field, const std::vector<VertexId>& generators,
                                 const SurfacePoint& start);

}  // namespace gvd
