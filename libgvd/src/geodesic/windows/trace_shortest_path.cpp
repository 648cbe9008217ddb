// Shortest paths, traced back from a point to its nearest generator.
//
// Idea: the best source of the point's faces shows where the path enters the face, and its image. The line towards the
// image crosses face after face until it meets the vertex that the image is of. From a pseudo-source it goes on in the
// same way, so only the windows at the bends are read.
// Source: Mitchell, Mount and Papadimitriou (1987).
// Invariant: each vertex of the path is nearer to the generator than the one before, so that the path ends.
#include <algorithm>
#include <cmath>

#include "geodesic/face_layout.hpp"
#include "geodesic/windows/face_frames.hpp"
#include "geodesic/windows/window_queries.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

/// A line that passes a corner at no more than this angle, in radians, ends there. The path continues with the
/// corner's own shortest path. Otherwise rounding could lead the line past the wrong side of the corner at which its
/// window ends. Far above the rounding error of an image (1e-13), far below the angle to another corner.
constexpr double kAtCorner = 1e-9;

/// A straight line towards an image, at the point where it crosses a halfedge into the halfedge's face.
struct Step {
  HalfedgeId halfedge;
  double t;    // from the halfedge's start, mesh units
  Vec2 image;  // in the frame of the halfedge, its face above
};

class PathTracer {
 public:
  PathTracer(const Mesh& mesh, const WindowField& field, const std::vector<VertexId>& generators)
      : mesh_(mesh), field_(field), generators_(generators) {}

  GeodesicPath trace(const SurfacePoint& start) {
    path_.points.push_back(start);
    for (const FaceId f : faces_around(mesh_, start)) look_from(f, start);
    path_.length = best_distance_;
    if (std::isinf(best_distance_)) return std::move(path_);
    path_.generator = best_.generator;
    for (VertexId v = follow_best(); v != generators_[path_.generator.index()];) {
      best_distance_ = kInfinity;
      for_each_outgoing(mesh_, v, [&](HalfedgeId h) { look_from(Mesh::face(h), edge_point(h, 0), v); });
      if (std::isinf(best_distance_)) return std::move(path_);  // rounding hides the continuation
      const VertexId nearer = follow_best();
      // Rounding again: the path would never end.
      if (!(field_.distance[nearer] < field_.distance[v])) return std::move(path_);
      v = nearer;
    }
    path_.complete = true;
    return std::move(path_);
  }

 private:
  /// Looks for a shorter path to p through face f. If p is the vertex `reached`, the path must continue from there: it
  /// must come from a vertex nearer to the generator, and across the opposite edge or along a side.
  void look_from(FaceId f, const SurfacePoint& p, VertexId reached = VertexId()) {
    collect_face_sources(mesh_, field_, f, sources_);
    const Vec2 at = *locate_in_face(mesh_, f, p);
    for (const FaceSource& s : sources_) {
      if (reached.valid() && !(s.offset < field_.distance[reached])) continue;
      if (reached.valid() && !s.is_corner && mesh_.opposite(s.halfedge) != reached) continue;
      if (path_.generator.valid() && s.generator != path_.generator) continue;
      const double d = s.distance(at);
      if (!(d < best_distance_)) continue;
      best_ = s;
      best_distance_ = d;
      best_point_ = at;
    }
  }

  /// Follows the best path to the vertex from which it comes.
  VertexId follow_best() {
    if (best_.is_corner) return go_to(best_.halfedge);
    const FaceLayout layout(mesh_, Mesh::face(best_.halfedge));
    const int i = Mesh::corner(best_.halfedge);
    const Vec2 origin = layout.corner[i], along = layout.side(i);
    const Vec2 image = best_.image - origin;
    const double length = mesh_.length(best_.halfedge), t = along.dot(best_.entry(best_point_) - origin);
    // In the frame of the opposite halfedge, the edge runs the other way.
    Step step{mesh_.twin(best_.halfedge), length - t, {length - along.dot(image), std::abs(cross(along, image))}};
    for (;;) {
      const double fraction = step.t / mesh_.length(step.halfedge);
      if (fraction <= kAtCorner) return go_to(step.halfedge);
      if (fraction >= 1 - kAtCorner) return go_to(Mesh::next(step.halfedge));
      const SurfacePoint crossing = edge_point(step.halfedge, fraction);
      path_.points.push_back(make_surface_point(crossing.face, crossing.bary));
      const VertexId v = advance(step);
      if (v.valid()) return v;
    }
  }

  /// Ends a line at the vertex that `outgoing` leaves.
  VertexId go_to(HalfedgeId outgoing) {
    const VertexId v = mesh_.from(outgoing);
    const SurfacePoint& last = path_.points.back();
    if (last.kind() != SurfacePoint::Kind::vertex || vertex(mesh_, last) != v) {
      path_.points.push_back(edge_point(outgoing, 0));
    }
    return v;
  }

  /// Crosses one face. Returns the vertex at which the line ends, or advances the step to the next face.
  VertexId advance(Step& step) {
    const HalfedgeId k = step.halfedge;
    const FaceFrame f = make_face_frame(mesh_, Mesh::face(k));
    const int i = Mesh::corner(k);
    const double left = f.length[(i + 2) % 3], base = f.length[i];
    const Vec2 apex(left * f.cosine[i], left * f.sine[i]), at(step.t, 0);
    const double beside = cross(step.image - at, apex - at);
    if (std::abs(beside) <= kAtCorner * (step.image - at).norm() * (apex - at).norm()) return go_to(Mesh::previous(k));
    const bool to_right = beside > 0;
    const HalfedgeId side = to_right ? Mesh::next(k) : Mesh::previous(k);
    if (!mesh_.twin(side).valid()) return go_to(Mesh::previous(k));  // it grazes a boundary corner
    const Vec2 origin = to_right ? Vec2(base, 0) : apex, target = to_right ? apex : Vec2(0, 0);
    const double length = mesh_.length(side);
    const Vec2 along = (target - origin) / length;
    const double inside = cross(along, at - origin), outside = -cross(along, step.image - origin);
    // The vertex lies in this face and rounding led past it: the line would never end.
    if (outside < -kAtCorner * length) return go_to(nearest_corner(k, step.image, base, apex));
    const double from_x = along.dot(at - origin), image_x = along.dot(step.image - origin);
    const double fraction = inside + outside > 0 ? inside / (inside + outside) : 0;
    const double t = std::clamp(from_x + fraction * (image_x - from_x), 0.0, length);
    step = {mesh_.twin(side), length - t, {length - image_x, outside}};
    return VertexId();
  }

  /// The halfedge that leaves the corner nearest to p, in the frame of halfedge k.
  static HalfedgeId nearest_corner(HalfedgeId k, const Vec2& p, double base, const Vec2& apex) {
    const double to_start = p.squaredNorm(), to_end = (p - Vec2(base, 0)).squaredNorm();
    const double to_apex = (p - apex).squaredNorm();
    if (to_apex <= std::min(to_start, to_end)) return Mesh::previous(k);
    return to_start <= to_end ? k : Mesh::next(k);
  }

  const Mesh& mesh_;
  const WindowField& field_;
  const std::vector<VertexId>& generators_;
  GeodesicPath path_;
  std::vector<FaceSource> sources_;
  FaceSource best_{};
  double best_distance_ = kInfinity;
  Vec2 best_point_ = Vec2::Zero();
};

}  // namespace

GeodesicPath trace_shortest_path(const Mesh& mesh, const WindowField& field, const std::vector<VertexId>& generators,
                                 const SurfacePoint& start) {
  return PathTracer(mesh, field, generators).trace(start);
}

}  // namespace gvd
