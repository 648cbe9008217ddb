#pragma once

// Creases, for the library itself: gvd/creases.hpp has what users need.

#include <cstdint>
#include <vector>

#include "gvd/creases.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// Tells by the unit normals of two faces whether they meet at a crease. A face without area has the normal 0 and makes
/// none.
class CreaseTest {
 public:
  /// `angle`: degrees, in (0, 180].
  explicit CreaseTest(double angle);
  bool operator()(const Vec3& here, const Vec3& there) const;

 private:
  double bound_;  // radians
};

/// Throws Error{invalid_option} for an angle that is not in (0, 180] degrees.
void check_crease_angle(double angle);

/// Length of the edges, mesh units.
double total_length(const Mesh& mesh, const std::vector<EdgeId>& edges);

/// Creases that are connected.
struct CreaseGroup {
  std::vector<EdgeId> edges;       ///< ascending
  std::vector<VertexId> vertices;  ///< their ends, ascending
  double length = 0;               ///< mesh units

  /// Whether generators this far apart can follow the group: it is three times as long.
  bool is_long(double spacing) const;
};

/// The connected groups of creases, by their first vertices. Cost: O(n).
std::vector<CreaseGroup> group_creases(const Mesh& mesh, const std::vector<EdgeId>& creases);

/// The creases of the groups that are long, ascending.
std::vector<EdgeId> keep_long(const std::vector<CreaseGroup>& groups, double spacing);

/// The creases around each vertex, and the corners at which curves of them end (see trace_creases).
class CreaseNetwork {
 public:
  /// The mesh has to outlive this. `corner_distance`: as in trace_creases. Cost: O(n log n).
  CreaseNetwork(const Mesh& mesh, const std::vector<EdgeId>& creases, double corner_distance = 0);

  bool is_crease(EdgeId e) const { return is_crease_[e]; }
  /// Whether the point lies on a crease.
  bool contains(const SurfacePoint& point) const {
    if (point.kind() == SurfacePoint::Kind::vertex) return !leaving_[vertex(mesh_, point)].empty();
    return point.kind() == SurfacePoint::Kind::edge && is_crease_[mesh_.edge(halfedge(point))];
  }
  /// Whether no curve passes a vertex: it has one crease or more than two, or none, or its two make a sharp turn.
  bool is_corner(VertexId v) const { return is_corner_[v]; }

  /// A crease, in one of its directions.
  struct Step {
    EdgeId edge;
    bool forwards;  ///< as its halfedge `mesh.halfedge(edge)` runs
  };
  VertexId start(const Step& step) const {
    const HalfedgeId h = mesh_.halfedge(step.edge);
    return step.forwards ? mesh_.from(h) : mesh_.to(h);
  }
  VertexId end(const Step& step) const { return start({step.edge, !step.forwards}); }
  /// The creases that leave a vertex, ascending.
  const std::vector<Step>& leaving(VertexId v) const { return leaving_[v]; }
  /// The crease after this one along the curve; none, with an invalid edge, at a corner.
  Step next(const Step& step) const { return is_corner(end(step)) ? Step{EdgeId(), true} : onward(step); }

 private:
  /// The crease after this one, over a vertex with two.
  Step onward(const Step& step) const {
    const std::vector<Step>& steps = leaving_[end(step)];
    return steps[steps[0].edge == step.edge ? 1 : 0];
  }
  double turn_cosine(VertexId v, int edges) const;
  bool reaches_kept_corner(VertexId v, double distance, const IdVector<VertexId, bool>& kept) const;
  void thin_corners(double distance);

  const Mesh& mesh_;
  IdVector<EdgeId, bool> is_crease_;
  IdVector<VertexId, std::vector<Step>> leaving_;
  IdVector<VertexId, bool> is_corner_;
};

/// trace_creases, for a network that is there.
std::vector<CreaseCurve> trace_curves(const Mesh& mesh, const CreaseNetwork& network,
                                      const std::vector<EdgeId>& creases);

/// The point of an edge at a distance from one of its ends, mesh units, which is limited to the edge.
SurfacePoint point_on_edge(const Mesh& mesh, EdgeId edge, VertexId start, double distance);

/// The points of a curve at these lengths from its first vertex, mesh units, ascending. Cost: O(edges + points).
std::vector<SurfacePoint> points_on_curve(const Mesh& mesh, const CreaseCurve& curve, const std::vector<double>& at);

}  // namespace gvd
