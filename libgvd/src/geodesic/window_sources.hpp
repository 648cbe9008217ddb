#pragma once

#include <limits>
#include <vector>

#include "geodesic/window_field.hpp"
#include "gvd/mesh.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// One of the ways to the points of an edge, in coordinates along it: straight from an image through an interval of the
/// edge, or along the edge from one of its ends.
struct EdgeSource {
  double begin, end;  ///< interval that it sees, from the start of the halfedge, mesh units
  double x, depth;    ///< the image's foot on the edge, and its distance from the edge, >= 0
  double offset;      ///< distance from the generator to the image's vertex
  GeneratorId generator;

  /// Length of a path to the point t of the edge: straight from the image for t in [begin, end], and round the near end
  /// of the interval elsewhere. Continuous; never below the exact distance.
  double distance(double t) const;
};

/// All ways to the points of the edge of halfedge h: the windows from both sides, then the cones of its two ends.
/// In coordinates from `from(h)`. Replaces what `sources` held. Cost: O(windows on the two faces).
void collect_edge_sources(const Mesh& mesh, const WindowField& field, HalfedgeId h, std::vector<EdgeSource>& sources);

/// One of the ways to the points of a face, in the face's layout (FaceLayout): straight from an image through an
/// interval of one of its sides, or from a corner.
struct FaceSource {
  Vec2 image;
  Vec2 begin, end;  ///< ends of the interval; both the image itself for a corner
  double offset;    ///< distance from the generator to the image's vertex
  GeneratorId generator;
  HalfedgeId halfedge;  ///< the side that it comes through; for a corner the halfedge that leaves it
  bool is_corner;

  /// Where a path to p enters: the point of the interval next to the straight line from the image.
  Vec2 entry(const Vec2& p) const;
  /// Length of a path to p through entry(p). Continuous; never below the exact distance.
  double distance(const Vec2& p) const;
};

/// All ways to the points of face f: the windows that enter through its sides, then the cones of its corners.
/// Replaces what `sources` held. Cost: O(windows on the face).
void collect_face_sources(const Mesh& mesh, const WindowField& field, FaceId f, std::vector<FaceSource>& sources);

/// The nearest of the sources; ties go to the lower generator, then to the one that comes first. Null where there is
/// none.
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
