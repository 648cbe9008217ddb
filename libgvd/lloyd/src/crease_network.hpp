#pragma once

#include <array>
#include <vector>

#include "gvd/features.hpp"
#include "gvd/geodesic_tracing.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// The largest angle by which a crease turns at a vertex that is no corner, degrees.
inline constexpr double kCornerTurn = 45;

/// The point of an edge at a distance from one of its ends, mesh units, which is limited to the edge.
SurfacePoint point_on_edge(const Mesh& mesh, EdgeId edge, VertexId start, double distance);

/// The creases of a mesh as curves from corner to corner.
class CreaseNetwork {
 public:
  /// The mesh has to outlive this. Cost: O(n).
  CreaseNetwork(const Mesh& mesh, const std::vector<EdgeId>& creases);

  /// Thins the corners where a crease only turns. One stays if it is at least this far, along the crease, from corners
  /// that turn more and from those where other creases begin; mesh units. Cost: O(n log n).
  void thin_corners(double distance);

  bool is_crease(EdgeId e) const { return is_crease_[e]; }
  /// Whether the point lies on a crease.
  bool contains(const SurfacePoint& point) const {
    if (point.kind() == SurfacePoint::Kind::vertex) return !leaving_[vertex(mesh_, point)].empty();
    return point.kind() == SurfacePoint::Kind::edge && is_crease_[mesh_.edge(halfedge(point))];
  }
  /// Whether a vertex ends a curve: it has one crease edge or more than two, or the crease turns sharply there.
  bool is_corner(VertexId v) const { return is_corner_[v]; }

  /// The tangent vector at a point of a crease nearest to `tangent` among those along the crease. Zero at a corner.
  Vec2 project(const SurfacePoint& point, const Vec2& tangent) const;
  /// Follows the crease from a point of it in the direction of `tangent`, which lies along the crease, by its length,
  /// or to the next corner. Cost: O(edges passed).
  GeodesicTrace follow(const SurfacePoint& point, const Vec2& tangent) const;

  /// A crease edge, in one of its directions.
  struct Step {
    EdgeId edge;
    bool forwards;  ///< as its halfedge `mesh.halfedge(edge)` runs
  };
  VertexId start(const Step& step) const {
    const HalfedgeId h = mesh_.halfedge(step.edge);
    return step.forwards ? mesh_.from(h) : mesh_.to(h);
  }
  VertexId end(const Step& step) const { return start({step.edge, !step.forwards}); }
  /// The crease edges that leave a vertex, in the order of their edges.
  const std::vector<Step>& leaving(VertexId v) const { return leaving_[v]; }
  /// The edge after this one along the curve; none, with an invalid edge, at a corner.
  Step next(const Step& step) const { return is_corner(end(step)) ? Step{EdgeId(), true} : onward(step); }

 private:
  /// The edge after this one, over a vertex with two crease edges.
  Step onward(const Step& step) const {
    const std::vector<Step>& steps = leaving_[end(step)];
    return steps[steps[0].edge == step.edge ? 1 : 0];
  }
  /// The cosine of the turn over so many edges on both sides.
  double turn_cosine(VertexId v, int edges) const;
  bool reaches_kept_corner(VertexId v, double distance, const IdVector<VertexId, bool>& kept) const;
  Vec3 chord(Step step, int edges) const;
  Vec2 direction(const SurfacePoint& point, const Step& step) const;
  Vec2 end_direction(const SurfacePoint& point, const Step& step) const;
  /// The two ways along the crease from a point that is no corner.
  std::array<Step, 2> ways(const SurfacePoint& point) const;
  double length(const Step& step) const { return mesh_.length(step.edge); }

  const Mesh& mesh_;
  IdVector<EdgeId, bool> is_crease_;
  IdVector<VertexId, std::vector<Step>> leaving_;
  IdVector<VertexId, bool> is_corner_;
};

/// The curves of a network that was made of these creases (see trace_creases).
std::vector<CreaseCurve> trace_curves(const Mesh& mesh, const CreaseNetwork& network,
                                      const std::vector<EdgeId>& creases);

}  // namespace gvd
