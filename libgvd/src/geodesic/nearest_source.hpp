#pragma once

#include <span>
#include <vector>

#include "geodesic/distance_field.hpp"
#include "gvd/vec.hpp"

// Functions that find the nearest of the sources of an edge or of a face.

namespace gvd {

/// Replaces `best` by the path of a source to p if that is shorter. Returns whether it is.
[[gnu::always_inline]] inline bool take_nearer(const FaceSource& source, const Vec2& p, FaceSource::Path& best) {
  // No path of a source is shorter than the straight one. This test costs no square root.
  const double rest = best.distance - source.offset;
  if (!(rest > 0) || (p - source.image).squaredNorm() >= rest * rest) return false;
  const auto path = source.shortest_path(p);
  if (!(path.distance < best.distance)) return false;
  best = path;
  return true;
}

/// The shortest path of several sources of a face, and its source. If there is none, the source is null and the path
/// infinite.
struct NearestSource {
  const FaceSource* source;
  FaceSource::Path path;
};

/// The shortest path of these sources to p; if several are equally long, that of the first source. Cost: O(sources).
inline NearestSource nearest(std::span<const FaceSource> sources, const Vec2& p) {
  NearestSource best{nullptr, {kInfinity, p}};
  for (const FaceSource& source : sources) {
    if (take_nearer(source, p, best.path)) best.source = &source;
  }
  return best;
}

/// The source with the shortest path to p. Ties go to the lower generator, then to the source that comes first. Null if
/// there is none.
template <class Source, class Point>
const Source* nearest_source(const std::vector<Source>& sources, const Point& p, double& distance) {
  const Source* best = nullptr;
  distance = kInfinity;
  for (const Source& source : sources) {
    const double d = source.distance(p);
    if (!(d < distance) && !(best && d == distance && source.generator < best->generator)) continue;
    best = &source;
    distance = d;
  }
  return best;
}

}  // namespace gvd
