#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/vec.hpp"

// Discs of faces in the plane, by convex combination maps.

namespace gvd {

/// A vertex of the border of a disc, and where it is put.
struct DiscBorderPoint {
  VertexId vertex;
  Vec2 point;
};

/// The vertices of the loop of a halfedge on the boundary, from its start on. Cost: O(k) for k of them.
std::vector<VertexId> trace_boundary_loop(const Mesh& mesh, HalfedgeId h);

/// Scales ascending numbers that begin with 0 so that the last one is `last`, bit by bit. Makes their distances
/// more even.
/// `even_share`: share of even spacing in their distances, in [0, 1]. It keeps numbers apart that nearly coincide.
/// Needs two numbers at least, of which the last one is above 0. Cost: O(k).
void scale_and_even(std::vector<double>& values, double last, double even_share);

/// Points round the origin, by their angles and their distances. The last angle is that of the first point again, after
/// a full turn, and has no point. Cost: O(k).
std::vector<Vec2> lay_round(const std::vector<double>& angles, const std::vector<double>& radii);

/// Vertices of a disc, and their points of the plane.
struct PlaneDisc {
  std::vector<VertexId> vertices;  ///< ascending
  std::vector<Vec2> points;        ///< in the same order

  /// The number of v among the vertices, which it must be one of.
  std::size_t number(VertexId v) const {
    return std::lower_bound(vertices.begin(), vertices.end(), v) - vertices.begin();
  }
  const Vec2& at(VertexId v) const { return points[number(v)]; }
};

/// Weights of the neighbours of a vertex. All are positive.
enum class DiscWeights {
  mean_value,  ///< keep angles, about
  uniform,     ///< 1
};

/// The convex combination map of a disc of faces: every inner vertex is the weighted mean of its neighbours.
///
/// `border` is the whole border. The map is one-to-one, but for rounding, if two conditions hold. The border goes to a
/// convex polygon, and no inner edge joins two vertices of one side of it. `is_oriented` tells whether the map is
/// one-to-one with rounding, too.
/// Throws Error{no_valid_result} where the system can't be solved. Cost: a sparse system of the inner vertices.
PlaneDisc flatten_disc(const Mesh& mesh, const std::vector<FaceId>& faces, const std::vector<DiscBorderPoint>& border,
                       DiscWeights weights);

/// Whether every face is counter-clockwise in the plane, for certain. Cost: O(n log n).
bool is_oriented(const Mesh& mesh, const std::vector<FaceId>& faces, const PlaneDisc& disc);

}  // namespace gvd
