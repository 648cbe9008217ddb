#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/vec.hpp"

// Maps discs of faces into the plane by convex combination maps.

namespace gvd {

/// A vertex on the border of a disc, and its point in the plane.
struct DiscBorderPoint {
  VertexId vertex;
  Vec2 point;
};

/// The vertices of a boundary loop, beginning with the start of halfedge h, which lies on the boundary. Cost: O(k) for
/// k vertices.
std::vector<VertexId> trace_boundary_loop(const Mesh& mesh, HalfedgeId h);

/// Scales ascending numbers that begin with 0 so that the last one is exactly `last`, and makes their distances more
/// even.
/// `even_share`, in [0, 1], is the share of even spacing in the distances. It keeps numbers apart that nearly coincide.
/// There must be at least two numbers, and the last one must be above 0. Cost: O(k).
void scale_and_even(std::vector<double>& values, double last, double even_share);

/// Places points around the origin by their angles and distances. The last angle is the first point's angle again,
/// after a full turn, and gets no point. Cost: O(k).
std::vector<Vec2> lay_round(const std::vector<double>& angles, const std::vector<double>& radii);

/// The vertices of a disc and their points in the plane.
struct PlaneDisc {
  std::vector<VertexId> vertices;  ///< ascending
  std::vector<Vec2> points;        ///< in the same order

  /// The index of v, which must be one of the vertices. Cost: O(log k).
  std::size_t number(VertexId v) const {
    return std::lower_bound(vertices.begin(), vertices.end(), v) - vertices.begin();
  }
  const Vec2& at(VertexId v) const { return points[number(v)]; }
};

/// How the neighbours of a vertex are weighted. All weights are positive.
enum class DiscWeights {
  mean_value,  ///< nearly preserves angles
  uniform,     ///< all weights are 1
};

/// The convex combination map of a disc of faces: every inner vertex is the weighted mean of its neighbours.
///
/// `border` lists the whole border. Apart from rounding, the map is one-to-one if the border's points form a convex
/// polygon and no inner edge joins two vertices on the same side of the polygon. `is_oriented` tells whether the
/// computed map is one-to-one.
/// Nothing if the system can't be solved. Cost: solving a sparse system with a row for each inner vertex.
std::optional<PlaneDisc> flatten_disc(const Mesh& mesh, const std::vector<FaceId>& faces,
                                      const std::vector<DiscBorderPoint>& border, DiscWeights weights);

/// Whether every face is certainly counter-clockwise in the plane. Cost: O(n log n).
bool is_oriented(const Mesh& mesh, const std::vector<FaceId>& faces, const PlaneDisc& disc);

}  // namespace gvd
