#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "geodesic/windows/face_frames.hpp"
#include "geodesic/windows/parallel_windows.hpp"
#include "geodesic/windows/vertex_fan.hpp"
#include "geodesic/windows/window.hpp"
#include "geodesic/windows/window_filters.hpp"
#include "geodesic/windows/window_geometry.hpp"

namespace gvd {

/// The best path so far to each copy of a vertex: its length and its generator.
struct DistanceLabels {
  IdVector<VertexCopyId, double> distance;      ///< mesh units; infinity if there is no path yet
  IdVector<VertexCopyId, GeneratorId> label;    ///< invalid if there is no path yet, or provisional
  IdVector<VertexCopyId, Departure> departure;  ///< empty unless departures are recorded

  explicit DistanceLabels(std::size_t copies, bool with_departures = false)
      : distance(copies, kInfinity), label(copies), departure(with_departures ? copies : 0) {}

  /// Whether a path of this length from this generator precedes the best one so far (is_before).
  bool is_improved_by(VertexCopyId v, double d, GeneratorId generator) const {
    return is_before(d, generator, distance[v], label[v]);
  }
  /// Whether a vertex copy has a label other than `generator`. A copy without a path takes this label provisionally, so
  /// that the first path to it shows whether the label changes.
  bool has_other_label(VertexCopyId v, GeneratorId generator) {
    GeneratorId& known = label[v];
    if (!known.valid()) known = generator;
    return known != generator;
  }
};

/// An edge that a window has reached, in the window's frame.
struct WindowEdge {
  double length;
  VertexCopyId start, end;
  HalfedgeId behind;  ///< halfedge of the face that the window leaves
};

/// The edge of a window that leaves face f by the halfedge of corner `side` (0 to 2), which ends at corner `next`.
inline WindowEdge exit_edge(const FaceFrame& f, HalfedgeId behind, std::size_t side, std::size_t next) {
  return {f.length[side], f.vertex[next], f.vertex[side], behind};
}

/// The halfedge by which windows enter a face, and the face as seen from there. Many windows enter by the same
/// halfedge, one after the other, so that whatever they have in common is computed once.
struct FaceEntry {
  const FaceFrame& frame;
  HalfedgeId halfedge;
  std::size_t start, end, top;  ///< corners; the halfedge leads from `start` to `end`, and the apex is at `top`
  double base;                  ///< length of the halfedge
  double longest;               ///< square of the longest side of the face
  double apex_x, apex_y;        ///< in the frame of the windows on the halfedge
  bool has_flat_apex;
  ExitSide left, right;
  WindowEdge left_edge, right_edge;

  FaceEntry(const FaceFrames& frames, HalfedgeId h)
      : frame(frames.frame[Mesh::face(h)]),
        halfedge(h),
        start(Mesh::corner(h)),
        end((start + 1) % 3),
        top((start + 2) % 3),
        base(frame.length[start]),
        longest(std::max(
            {frame.length[0] * frame.length[0], frame.length[1] * frame.length[1], frame.length[2] * frame.length[2]})),
        apex_x(frame.length[top] * frame.cosine[start]),
        apex_y(frame.length[top] * frame.sine[start]),
        has_flat_apex(frames.kind[frame.vertex[top]] == VertexKind::flat),
        left(left_exit(frame, start)),
        right(right_exit(frame, start)),
        left_edge(exit_edge(frame, leaving(top), top, start)),
        right_edge(exit_edge(frame, leaving(end), end, top)) {}

  /// The halfedge of the face that leaves a corner.
  HalfedgeId leaving(std::size_t corner) const {
    return HalfedgeId(halfedge.value() + static_cast<std::int32_t>(corner) - static_cast<std::int32_t>(start));
  }
};

/// Carries a window across the face that it enters: offers paths to the apex, and splits the window at the apex.
///
/// Source: Chen and Han (1990); the gaps that rounding opens are closed as window_geometry.hpp says.
class FaceCrossing {
 public:
  /// `apex_path` has for each halfedge the best straight path across it to the apex; it is used only if there are
  /// needles. `angles` is empty unless departures are recorded; `starts` is read only in that case. All must outlive
  /// this object.
  FaceCrossing(const FaceFrames& frames, const DistanceLabels& labels, IdVector<HalfedgeId, ApexPath>& apex_path,
               const CornerAngles& angles, const StartDistances& starts)
      : labels_(labels),
        angles_(angles),
        starts_(starts),
        has_departures_(!angles.empty()),
        apex_path_(apex_path),
        has_needles_(frames.has_needles),
        has_thin_faces_(frames.has_thin_faces),
        drift_(std::ldexp(kPositionRounding, -std::ilogb(std::max(frames.least_sine, kLeastPositive)))) {}

  /// Calls target.reach_vertex(VertexCopyId, const VertexPath&) for paths to the apex, and then
  /// target.enqueue_on_edge(const Window&, const WindowHistory&, const WindowEdge&) for each of the two sides that the
  /// window continues to. At the boundary these windows have no valid halfedge.
  /// It is always inlined, because it belongs to the innermost loop.
  template <class Target>
  [[gnu::always_inline]] void cross(const PropagatedWindow& entering, const FaceEntry& entry, Target& target) {
    const Window& w = entering.window;
    const FaceFrame& f = entry.frame;
    const ApexView apex(w, entry.apex_x, entry.apex_y);
    Exits exits{!apex.all_right(), !apex.all_left()};
    if (apex.covered() || (!is_far_beside(w, apex, entry.longest) && is_grazed(w, apex, entry.base)) ||
        (has_thin_faces_ && is_in_gap(w, apex, drift_))) {
      const double image_distance = std::sqrt(apex.squared_image_distance(w));
      reach_apex(entering, entry, apex, image_distance, target);
      if (has_needles_ && apex.covered()) exits = split_at_apex(w, entry, apex, image_distance);
    }
    if (std::isinf(labels_.distance[f.vertex[entry.top]])) reach_apex_along_sides(entry, target);
    leave(entering, entry, apex, exits, target);
  }

  /// The same for a parallel window, with target.enqueue_parallel_on_edge. Curves have no departures. These windows are
  /// rare enough for a function call. If several windows cover the apex, all of them split there; the strips of one
  /// curve do not overlap, so that windows do not double from face to face.
  template <class Target>
  [[gnu::noinline]] void cross_parallel(const PropagatedWindow& entering, const FaceEntry& entry, Target& target) {
    const Window& w = entering.window;
    const ParallelApexView apex(w, entry.apex_x, entry.apex_y);
    const VertexCopyId top = entry.frame.vertex[entry.top];
    if (apex.covered() || apex.is_grazed(w, entry.base)) {
      const ParallelPaths paths(w);
      const double cosine = entry.left.cosine, sine = entry.left.sine;
      // The direction back, turned from the side that leads from the apex to the edge's start; see reach_apex.
      const Rotation back{cosine * paths.along + sine * paths.across, cosine * paths.across - sine * paths.along};
      target.reach_vertex(top, {paths.distance(apex.x, apex.y), w.generator, {entry.leaving(entry.top), back}});
    }
    if (std::isinf(labels_.distance[top])) reach_apex_along_sides(entry, target);
    WindowHistory history = entering.history;
    if (has_thin_faces_ && is_cycle_check_step(++history.crossed_faces)) {
      history.cycle_check_face = Mesh::face(entry.halfedge);
    }
    if (!apex.all_right())
      target.enqueue_parallel_on_edge(cross_left_parallel(w, entry.left, apex), history, entry.left_edge);
    if (!apex.all_left()) {
      target.enqueue_parallel_on_edge(cross_right_parallel(w, entry.base, entry.right, apex), history,
                                      entry.right_edge);
    }
  }

 private:
  /// Hands the sub-windows on to the target. If a flat apex splits the window, the two parts may be joined again behind
  /// it.
  template <class Target>
  [[gnu::always_inline]] void leave(const PropagatedWindow& entering, const FaceEntry& entry, const ApexView& apex,
                                    const Exits& exits, Target& target) {
    constexpr std::uint32_t kBegin = WindowHistory::kAtBegin, kEnd = WindowHistory::kAtEnd;
    const std::uint32_t split = entry.has_flat_apex ? kBegin | kEnd : 0;
    const std::uint32_t joinable = entering.history.joinable_ends;
    WindowHistory history = entering.history;
    if (has_thin_faces_ && is_cycle_check_step(++history.crossed_faces)) {
      history.cycle_check_face = Mesh::face(entry.halfedge);
    }
    const bool turns = has_departures_ && is_direct(entering.window);
    if (exits.left) {
      if (turns) history.departure = entering.history.departure + angles_.corner(entry.leaving(entry.start));
      const std::uint32_t at_end = apex.all_left() ? joinable : split;
      history.joinable_ends = ((joinable & kBegin) | (at_end & kEnd)) & 3u;
      target.enqueue_on_edge(cross_left(entering.window, entry.left, apex), history, entry.left_edge);
    }
    if (exits.right) {
      if (turns) history.departure = entering.history.departure - angles_.corner(entry.leaving(entry.end));
      const std::uint32_t at_begin = apex.all_right() ? joinable : split;
      history.joinable_ends = ((at_begin & kBegin) | (joinable & kEnd)) & 3u;
      target.enqueue_on_edge(cross_right(entering.window, entry.base, entry.right, apex), history, entry.right_edge);
    }
  }

  /// The sides of the face to which a window that covers the apex continues.
  Exits split_at_apex(const Window& w, const FaceEntry& entry, const ApexView& apex, double image_distance) {
    const ApexPath own{w.offset + image_distance, w.x + (apex.x - w.x) * w.depth / (w.depth + apex.y)};
    const double tolerance = kSameImage * image_distance + kPositionRounding * entry.frame.length[entry.start];
    return exits_beside(apex_path_[entry.halfedge], own, tolerance);
  }

  /// Offers the straight path from the window's image to the apex.
  template <class Target>
  void reach_apex(const PropagatedWindow& entering, const FaceEntry& entry, const ApexView& apex, double image_distance,
                  Target& target) {
    const Window& w = entering.window;
    const FaceFrame& f = entry.frame;
    const double d = w.offset + image_distance;
    if (!labels_.is_improved_by(f.vertex[entry.top], d, w.generator)) return;
    // The direction back to the image, turned from the side that leads from the apex to the edge's start.
    const double back_x = (w.x - apex.x) / image_distance, back_y = (-w.depth - apex.y) / image_distance;
    const double cosine = f.cosine[entry.start], sine = f.sine[entry.start];
    const Rotation angle{-cosine * back_x - sine * back_y, -cosine * back_y + sine * back_x};
    Departure departure = entering.history.departure;
    if (has_departures_ && is_direct(w)) {
      departure = departure + Departure::of_angle(std::atan2(apex.y + w.depth, apex.x - w.x));
    }
    target.reach_vertex(f.vertex[entry.top], {d, w.generator, {entry.leaving(entry.top), angle}, departure});
  }

  /// Offers the paths along the two sides to an apex that has no path yet. Every edge with a window therefore has
  /// distances at both ends; without them, no filter could drop the window. This makes the propagation end, whatever
  /// rounding does.
  template <class Target>
  void reach_apex_along_sides(const FaceEntry& entry, Target& target) {
    const FaceFrame& f = entry.frame;
    const VertexCopyId start = f.vertex[entry.start], end = f.vertex[entry.end], top = f.vertex[entry.top];
    const HalfedgeId outgoing = entry.leaving(entry.top);
    const HalfedgeId at_start = entry.leaving(entry.start), at_end = entry.leaving(entry.end);
    Departure from_start, from_end;
    if (has_departures_) {
      const bool leads_left = is_generator(start);  // the side that follows the corner at the start
      from_start = leads_left ? angles_.side(at_start) + angles_.corner(at_start) : labels_.departure[start];
      from_end = is_generator(end) ? angles_.side(at_end) : labels_.departure[end];
    }
    target.reach_vertex(
        top, {labels_.distance[start] + f.length[entry.top], labels_.label[start], {outgoing, {}}, from_start});
    const Rotation corner{f.cosine[entry.top], f.sine[entry.top]};
    target.reach_vertex(
        top, {labels_.distance[end] + f.length[entry.end], labels_.label[end], {outgoing, corner}, from_end});
  }

  /// Whether the paths of a window come straight from its generator. This is exact, because offsets are copied and
  /// never recomputed.
  bool is_direct(const Window& w) const { return w.offset == starts_[w.generator]; }
  bool is_generator(VertexCopyId v) const { return labels_.distance[v] == starts_[labels_.label[v]]; }

  const DistanceLabels& labels_;
  const CornerAngles& angles_;
  const StartDistances& starts_;
  bool has_departures_;
  IdVector<HalfedgeId, ApexPath>& apex_path_;
  bool has_needles_;     // without needles, no ApexPath is kept
  bool has_thin_faces_;  // without thin faces, faces are not counted and gaps are not looked for
  static constexpr double kLeastPositive = std::numeric_limits<double>::min();

  /// The angle by which rounding turns the directions of paths, in radians: kPositionRounding divided by the least
  /// sine, rounded to a power of two so that most sets of generators have the same value.
  double drift_;
};

}  // namespace gvd
