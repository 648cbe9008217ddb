// Traces a shortest path back to its generator.
//
// Idea: the best source of the point's faces shows where the path enters the face, and its image. The line towards the
// image crosses face after face until it meets the vertex that has this image. From a pseudo-source the path continues
// in the same way, so that only the windows at its bends are read.
// Source: the paths of Mitchell, Mount and Papadimitriou (1987).
// Invariant: each vertex of a path is nearer to the generator than the one before, so that the path ends.
#include "geodesic/windows/shortest_path.hpp"

#include <algorithm>
#include <cmath>

#include "base/plane.hpp"
#include "geodesic/face_layout.hpp"
#include "geodesic/windows/face_frames.hpp"
#include "geodesic/windows/window_sources.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

/// A line that passes a corner within this angle, in radians, ends there, and the path continues with the corner's own
/// shortest path. Otherwise rounding could lead the line past the wrong side of the corner at which its window ends.
/// The angle is far above the rounding error of an image (1e-13), and far below the angle to another corner.
constexpr double kAtCorner = 1e-9;

/// For vertices with more faces than this, the memo stores how paths continue. Few meshes have such vertices, so that
/// it is mostly empty.
constexpr int kManyFaces = 64;

/// A straight line towards an image, at the point where it crosses a halfedge into the halfedge's face.
struct CrossingLine {
  HalfedgeId halfedge;
  double t;    // position from the halfedge's start, mesh units
  Vec2 image;  // in the frame of the halfedge, its face above
};

class PathTracer {
 public:
  PathTracer(const Mesh& mesh, const WindowField& field, PathMemo& memo) : mesh_(mesh), field_(field), memo_(memo) {}

  GeodesicPath trace(const SurfacePoint& start, GeneratorId only) {
    path_.points.push_back(start);
    path_.generator = only;
    for (const FaceId f : faces_around(mesh_, start)) look_from(f, start);
    path_.length = best_.distance;
    path_.generator = std::isinf(best_.distance) ? GeneratorId() : best_.source.generator;
    if (!path_.generator.valid()) return std::move(path_);
    for (VertexId v = follow_best(); v.valid() && !is_on_generator(v);) {
      look_from(v);
      if (std::isinf(best_.distance)) return std::move(path_);  // rounding hides how the path continues
      const VertexId nearer = follow_best();
      if (!nearer.valid()) break;  // on a segment of a curve
      // By rounding, the path would never end.
      if (!(field_.distance[nearer] < field_.distance[v])) return std::move(path_);
      v = nearer;
    }
    path_.complete = true;
    return std::move(path_);
  }

 private:
  /// Whether a path ends at a vertex, which is its generator or, if that is a curve, a vertex of the curve.
  bool is_on_generator(VertexId v) const { return v == memo_.end(path_.generator) || field_.distance[v] == 0; }

  /// Looks for a shorter path to p through face f. If p is the vertex `reached`, the path must continue from there: it
  /// must come from a vertex nearer to the generator, and across the opposite edge or along a side.
  void look_from(FaceId f, const SurfacePoint& p, VertexId reached = VertexId()) {
    collect_face_sources(mesh_, field_, f, sources_);
    const Vec2 at = *locate_in_face(mesh_, f, p);
    for (const FaceSource& s : sources_) {
      if (reached.valid() && !(s.offset < field_.distance[reached])) continue;
      if (reached.valid() && !s.is_corner() && mesh_.opposite(s.halfedge) != reached) continue;
      if (path_.generator.valid() && s.generator != path_.generator) continue;
      const double d = s.distance(at);
      if (!(d < best_.distance)) continue;
      best_ = {s, d, at};
    }
  }

  /// Looks for the way on from a vertex.
  void look_from(VertexId v) {
    const PathMemo::Key key(v, path_.generator);
    if (const auto known = memo_.find(key)) {
      best_ = *known;
      return;
    }
    best_.distance = kInfinity;
    int faces = 0;
    for_each_outgoing(mesh_, v, [&](HalfedgeId h) {
      ++faces;
      look_from(Mesh::face(h), edge_point(h, 0), v);
    });
    if (faces > kManyFaces) memo_.add(key, best_);
  }

  /// Follows the best path back to the vertex from which it comes. Returns no vertex if it comes from a segment of a
  /// curve, where it ends.
  VertexId follow_best() {
    const FaceSource& source = best_.source;
    if (source.is_corner()) return go_to(source.halfedge);
    const FaceLayout layout(mesh_, Mesh::face(source.halfedge));
    const int i = Mesh::corner(source.halfedge);
    const Vec2 origin = layout.corner[i], along = layout.side(i);
    const Vec2 entry = source.entry(best_.at), image = source.origin(entry) - origin;
    const double length = mesh_.length(source.halfedge), t = along.dot(entry - origin);
    if (source.is_parallel() && begins_at(source.halfedge, std::abs(cross(along, image)))) {
      return end_on_segment(source.halfedge, t);
    }
    // In the frame of the opposite halfedge, the edge runs the other way.
    CrossingLine line{
        mesh_.twin(source.halfedge), length - t, {length - along.dot(image), std::abs(cross(along, image))}};
    for (;;) {
      const double fraction = line.t / mesh_.length(line.halfedge);
      if (fraction <= kAtCorner) return go_to(line.halfedge);
      if (fraction >= 1 - kAtCorner) return go_to(Mesh::next(line.halfedge));
      const SurfacePoint crossing = edge_point(line.halfedge, fraction);
      path_.points.push_back(make_surface_point(crossing.face, crossing.bary));
      const VertexId v = advance(line);
      if (v.valid() || !line.halfedge.valid()) return v;
    }
  }

  /// Whether parallel paths begin on the edge of a halfedge. `outside` is the distance of their beginning from the
  /// edge, which rounding of the path's direction over its faces can make different from 0.
  bool begins_at(HalfedgeId h, double outside) const {
    if (outside > kAtCorner * mesh_.length(h)) return false;
    bool begins = false;
    field_.windows.for_each(h, [&](const Window& w) { begins |= w.begins_here(); });
    return begins;
  }
  VertexId end_on_segment(HalfedgeId h, double t) {
    const SurfacePoint end = edge_point(h, std::clamp(t / mesh_.length(h), 0.0, 1.0));
    path_.points.push_back(make_surface_point(end.face, end.bary));
    return VertexId();
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

  /// Crosses one face. Returns the vertex at which the line ends, or advances the line to the next face.
  VertexId advance(CrossingLine& line) {
    const HalfedgeId k = line.halfedge;
    const FaceFrame f = make_face_frame(mesh_, Mesh::face(k));
    const int i = Mesh::corner(k);
    const double left = f.length[(i + 2) % 3], base = f.length[i];
    const Vec2 apex(left * f.cosine[i], left * f.sine[i]), at(line.t, 0);
    const double beside = cross(line.image - at, apex - at);
    if (std::abs(beside) <= kAtCorner * (line.image - at).norm() * (apex - at).norm()) return go_to(Mesh::previous(k));
    const bool to_right = beside > 0;
    const HalfedgeId side = to_right ? Mesh::next(k) : Mesh::previous(k);
    const Vec2 origin = to_right ? Vec2(base, 0) : apex, target = to_right ? apex : Vec2(0, 0);
    const double length = mesh_.length(side);
    const Vec2 along = (target - origin) / length;
    const double inside = cross(along, at - origin), outside = -cross(along, line.image - origin);
    if (best_.source.is_parallel() && begins_at(side, std::abs(outside))) {
      line.halfedge = HalfedgeId();
      return end_on_segment(side, along.dot(line.image - origin));
    }
    if (!mesh_.twin(side).valid()) return go_to(Mesh::previous(k));  // it grazes a boundary corner
    // The vertex lies in this face, and rounding led past it. The line would never end.
    if (outside < -kAtCorner * length) return go_to(nearest_corner(k, line.image, base, apex));
    const double from_x = along.dot(at - origin), image_x = along.dot(line.image - origin);
    const double fraction = inside + outside > 0 ? inside / (inside + outside) : 0;
    const double t = std::clamp(from_x + fraction * (image_x - from_x), 0.0, length);
    line = {mesh_.twin(side), length - t, {length - image_x, outside}};
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
  PathMemo& memo_;
  GeodesicPath path_;
  std::vector<FaceSource> sources_;
  PathMemo::Step best_{{}, kInfinity, Vec2::Zero()};  // the shortest continuation from the point reached
};

}  // namespace

GeodesicPath trace_shortest_path(const Mesh& mesh, const WindowField& field, PathMemo& memo, const SurfacePoint& start,
                                 GeneratorId only) {
  return PathTracer(mesh, field, memo).trace(start, only);
}

}  // namespace gvd
