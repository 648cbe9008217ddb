#pragma once

#include <array>
#include <vector>

#include "gvd/geodesic_tracing.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/vec.hpp"

namespace gvd {

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
  bool contains(const SurfacePoint& point) const;
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
  VertexId start(const Step& step) const;
  VertexId end(const Step& step) const { return start({step.edge, !step.forwards}); }
  /// The crease edges that leave a vertex, in the order of their edges.
  const std::vector<Step>& leaving(VertexId v) const { return leaving_[v]; }
  /// The edge after this one along the curve; none, with an invalid edge, at a corner.
  Step next(const Step& step) const;
  /// The point at a distance from the start of the step, in [0, length of the edge], mesh units.
  SurfacePoint at(const Step& step, double distance) const;

 private:
  bool turns(VertexId v, int edges) const;
  /// The cosine of the turn over so many edges on both sides.
  double turn_cosine(VertexId v, int edges) const;
  bool reaches_kept_corner(VertexId v, double distance, const IdVector<VertexId, bool>& kept) const;
  Vec3 chord(Step step, int edges) const;
  Vec2 direction(const SurfacePoint& point, const Step& step) const;
  Vec2 end_direction(const SurfacePoint& point, const Step& step) const;
  /// The two ways along the crease from a point that is no corner.
  std::array<Step, 2> ways(const SurfacePoint& point) const;

  const Mesh& mesh_;
  IdVector<EdgeId, bool> is_crease_;
  IdVector<VertexId, std::vector<Step>> leaving_;
  IdVector<VertexId, bool> is_corner_;
};

}  // namespace gvd
