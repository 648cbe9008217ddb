#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/parallel_chunks.hpp"
#include "base/plane.hpp"
#include "geodesic/field/face_layout.hpp"
#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// Straight paths that reach an edge: seen along the edge, they come from an image at (x, depth), whichever side it
/// lies on. Positions run along the edge's own halfedge, from 0 to its length. Mesh units.
struct EdgeSource {
  double begin, end;  ///< the interval that they reach straight
  double x, depth;    ///< the image; depth >= 0
  double offset;      ///< distance from the generator to the image
  GeneratorId generator;

  /// Length of the straight path to t, which is a path of the surface for t in [begin, end].
  double straight(double t) const { return offset + std::sqrt((t - x) * (t - x) + depth * depth); }
  /// Length of a path to t: straight to the interval, then along the edge. Continuous.
  double distance(double t) const {
    const double nearest = std::clamp(t, begin, end);
    return straight(nearest) + std::abs(t - nearest);
  }
};

/// Straight paths that enter a face through an opening: an interval of a side, or a corner. In the face's layout
/// (FaceLayout).
struct FaceSource {
  Vec2 image;
  Vec2 begin, end;  ///< the opening's ends, seen from the image on the left and on the right; a corner's are the image
  double offset;    ///< distance from the generator to the image
  GeneratorId generator;
  HalfedgeId halfedge;  ///< the side that they come through; for a corner the halfedge that leaves it
  bool is_corner;
  double distance_begin, distance_end;  ///< distance from the generator to the opening's two ends

  /// The last straight piece of a path, and its length in all.
  struct Path {
    double distance;
    Vec2 from;
  };
  /// The shortest path of this source to p: straight where p can be seen through the opening, round its end elsewhere.
  /// A path of the surface in any case, so an upper bound; continuous in p.
  Path shortest_path(const Vec2& p) const {
    const Vec2 ray = p - image;
    if (cross(ray, begin - image) < 0) return {distance_begin + (p - begin).norm(), begin};
    if (cross(ray, end - image) > 0) return {distance_end + (p - end).norm(), end};
    return {offset + ray.norm(), image};
  }
  double distance(const Vec2& p) const { return shortest_path(p).distance; }
  /// Where that path enters: the point of the opening next to the straight line from the image.
  Vec2 entry(const Vec2& p) const;
};

/// What a distance solver knows of the distances on edges and in faces near bisectors: what a tracer asks for. Several
/// threads may ask at once.
class DistanceField {
 public:
  virtual ~DistanceField() = default;

  /// Edges on which more than one generator may be the nearest, ascending.
  virtual std::vector<EdgeId> contested_edges(const ParallelChunks& parallel) const = 0;
  /// Overwrites `sources` with all that reach edge e; those of its two ends come first. The least distance over them is
  /// the distance to the nearest generator.
  virtual void collect(EdgeId e, std::vector<EdgeSource>& sources) const = 0;
  /// The same for the inside of face f, which is laid out like that.
  virtual void collect(FaceId f, const FaceLayout& layout, std::vector<FaceSource>& sources) const = 0;
};

/// The edges of a mesh that `is_wanted(EdgeId)` holds for, ascending.
template <class Wanted>
std::vector<EdgeId> find_edges(const Mesh& mesh, const ParallelChunks& parallel, const Wanted& is_wanted) {
  const auto edges = cut_into_chunks(static_cast<std::size_t>(mesh.edge_count()), kScanChunk);
  return parallel.collect(edges, {"bisectors", 0, 0}, [&](const Chunk& chunk) {
    std::vector<EdgeId> found;
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const EdgeId e(static_cast<std::int64_t>(i));
      if (is_wanted(e)) found.push_back(e);
    }
    return found;
  });
}

}  // namespace gvd
