#pragma once

#include <limits>
#include <vector>

#include "geodesic/field/distance_field.hpp"
#include "geodesic/windows/field/window_field.hpp"
#include "gvd/mesh.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// Overwrites `sources` with all that reach the edge of halfedge h: its two ends, then the windows from both sides.
/// Positions run from `from(h)`. Cost: O(windows on the two faces).
void collect_edge_sources(const Mesh& mesh, const WindowField& field, HalfedgeId h, std::vector<EdgeSource>& sources);

/// Overwrites `sources` with all that reach the points of face f, in its layout: the windows that enter through its
/// sides, then its corners. Cost: O(windows on the face).
void collect_face_sources(const Mesh& mesh, const WindowField& field, FaceId f, const FaceLayout& layout,
                          std::vector<FaceSource>& sources);
inline void collect_face_sources(const Mesh& mesh, const WindowField& field, FaceId f,
                                 std::vector<FaceSource>& sources) {
  collect_face_sources(mesh, field, f, FaceLayout(mesh, f), sources);
}

/// The source with the shortest path to p. Ties go to the lower generator, then to the one that comes first. Null if
/// there is none.
template <class Source, class Point>
const Source* nearest_source(const std::vector<Source>& sources, const Point& p, double& distance) {
  const Source* best = nullptr;
  distance = std::numeric_limits<double>::infinity();
  for (const Source& source : sources) {
    const double d = source.distance(p);
    if (!(d < distance) && !(best && d == distance && source.generator < best->generator)) continue;
    best = &source;
    distance = d;
  }
  return best;
}

}  // namespace gvd
