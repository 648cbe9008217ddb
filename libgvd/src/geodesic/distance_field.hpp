#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// Straight paths that reach an edge: seen along the edge, they come from an image at (x, depth), whichever side it lies on.
/// Positions run along the edge's own halfedge, from 0 to its length. Mesh units.
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

/// Straight paths that enter a face through an opening: an interval of a side, or a corner. In the face's plane.
struct FaceSource {
  GeneratorId generator;
  Vec2 image;
  Vec2 begin, end;                ///< the opening's ends, seen from the image on the left and on the right
  double offset;                  ///< distance from the generator to the image
  double reach_begin, reach_end;  ///< and to the two ends
  int place;                      ///< side i of the face, or 3 + i for its corner i

  /// The last straight piece of a path, and its length in all.
  struct Reach {
    double distance;
    Vec2 from;
  };
  /// Length of the straight path to p, which is a path of the surface where p can be seen through the opening.
  double straight(const Vec2& p) const { return offset + (p - image).norm(); }
  /// The shortest path of this source to p: straight where p can be seen through the opening, round its end elsewhere.
  /// A path of the surface in any case, so an upper bound; continuous in p.
  Reach reach(const Vec2& p) const {
    const Vec2 ray = p - image, left = begin - image, right = end - image;
    if (ray.x() * left.y() - ray.y() * left.x() < 0) return {reach_begin + (p - begin).norm(), begin};
    if (ray.x() * right.y() - ray.y() * right.x() > 0) return {reach_end + (p - end).norm(), end};
    return {offset + ray.norm(), image};
  }
};

/// What a distance solver knows of the distances on edges and in faces near bisectors: what a tracer asks for.
class DistanceField {
 public:
  virtual ~DistanceField() = default;

  /// The edges on which more than one generator may be the nearest, ascending.
  virtual std::vector<EdgeId> contested_edges() const = 0;
  /// Overwrites `sources` with all that reach edge e; those of its two ends come first. The least distance over them is the
  /// distance to the nearest generator.
  virtual void collect(EdgeId e, std::vector<EdgeSource>& sources) const = 0;
  /// The same for the inside of face f, whose corners lie at `corner` in the plane, counter-clockwise.
  virtual void collect(FaceId f, const std::array<Vec2, 3>& corner, std::vector<FaceSource>& sources) const = 0;
};

}  // namespace gvd
