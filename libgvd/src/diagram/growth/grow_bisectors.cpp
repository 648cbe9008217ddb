// Growth of the bisectors through one gap (section 4.3), as a loop over events.
//
// Every crossing on the rim starts an end. A queue holds the events that may happen next: two ends of one bisector
// join, two ends intersect at a branch point, or an end leaves its face and enters the next one. Each event that still
// applies makes nodes and arcs of the result, and new ends with their own events. The paper has the second and the
// third kind of event. The first kind is ours: a bisector that crosses a gap without a branch point has two ends there,
// which never intersect.
// Invariant: nodes and arcs are only appended, so an event refers to ends by index. The result is not trusted: growth
// ends with `check_growth`, and counts as failed if its result does not pass.
#include "diagram/growth/grow_bisectors.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "diagram/growth/check_growth.hpp"
#include "geodesic/face_layout.hpp"
#include "geodesic/marching/unfold.hpp"

namespace gvd {
namespace {

/// The number of events that are allowed per face of the gap. Growth that works has a few in each face; more mean a
/// loop.
constexpr std::size_t kStepsPerFace = 4;

class EventLoop {
 public:
  EventLoop(const GrowthInput& input, const Crossings& crossings, const Gap& gap, const GrowthRules& rules)
      : input_(input), mesh_(input.mesh()), crossings_(crossings), gap_(gap), rules_(rules), events_(rules.order) {}

  GrowthOutcome run() {
    if (!start_at_rim()) return failed();
    std::size_t steps = kStepsPerFace * gap_.faces.size() + 4 * ends_.size();
    while (active_ > 0) {
      if (events_.empty()) return failed();
      const GrowthEvent event = events_.pop();
      if (!is_current(event)) continue;
      if (steps-- == 0 || !handle(event)) return failed();
    }
    return {std::move(grown_), FaceId()};
  }

 private:
  GrowthOutcome failed() const { return {std::nullopt, entered_}; }

  bool is_current(const GrowthEvent& event) const {
    return ends_[event.first].active && (event.second == kNoEnd || ends_[event.second].active);
  }

  /// Handles an event. Returns false if growth can't continue.
  bool handle(const GrowthEvent& event) {
    switch (event.kind) {
      case GrowthEvent::Kind::joining:
        add_arc(event.first, ends_[event.second].node);
        deactivate(event.second);
        return true;
      case GrowthEvent::Kind::intersection:
        merge(event);
        return true;
      case GrowthEvent::Kind::exit:
        return leave_face(event.first);
    }
    return false;
  }

  /// Starts an end at every crossing on the rim. The images of its generators are unfolded in the face outside the gap,
  /// where only two generators compete. Returns false if a segment has to be stretched, but that face has none.
  bool start_at_rim() {
    for (const FaceId f : gap_.faces) {
      for (const BoundaryCrossing& c : boundary_crossings(mesh_, crossings_, f)) {
        const HalfedgeId h = Mesh::halfedge(f, c.corner), twin = mesh_.twin(h);
        if (!is_rim(mesh_, gap_, h)) continue;
        const FaceId outside = Mesh::face(twin);
        const auto plane = FaceLayout(mesh_, outside).corner;
        const Vec2 left = unfold_generator(plane, corner_distances(input_, outside, c.previous));
        const Vec2 right = unfold_generator(plane, corner_distances(input_, outside, c.next));
        const int node = add_node({GapNode::Kind::rim, c.id, {}, FaceId(), {}, 0});
        GrowingEnd end{outside, node, {}, c.previous, c.next, left, right};
        if (rules_.direction == GrowthRules::Direction::of_segment && !take_segment(c.id, end)) return false;
        enter(twin, c.t, node, end);
      }
    }
    return true;
  }

  /// Gives an end the direction of the segment in its face, towards crossing `to`. Returns false in a face of three
  /// labels, which has no segment, so that the gap has to take the face.
  bool take_segment(CrossingId to, GrowingEnd& end) {
    const auto ends = boundary_crossings(mesh_, crossings_, end.face);
    if (ends.size() != 2) {
      entered_ = end.face;
      return false;
    }
    const FaceLayout layout(mesh_, end.face);
    const int first = ends[1].id == to ? 0 : 1;
    end.direction = (layout.at(ends[1 - first].bary()) - layout.at(ends[first].bary())).normalized();
    return true;
  }

  int add_node(GapNode node) {
    grown_.nodes.push_back(std::move(node));
    return static_cast<int>(grown_.nodes.size()) - 1;
  }

  /// Adds an end with its events: its exit, and the events that it shares with other ends in its face.
  void add_end(GrowingEnd end, const std::array<Vec2, 3>& plane) {
    end.exit = find_exit(end, plane);
    const std::size_t own = ends_.size();
    if (end.exit) events_.push({GrowthEvent::Kind::exit, end.exit->distance, own, kNoEnd});
    ends_.push_back(std::move(end));
    ++active_;
    for (std::size_t other = 0; other < own; ++other) {
      if (!ends_[other].active || ends_[other].face != ends_[own].face) continue;
      add_joining(other, own);
      add_intersection(other, own);
      add_intersection(own, other);
    }
  }

  void add_joining(std::size_t first, std::size_t second) {
    const GrowingEnd &a = ends_[first], &b = ends_[second];
    if (a.left != b.right || a.right != b.left) return;
    const Vec2 way = b.start - a.start;
    if (!(way.dot(a.direction) > 0 && way.dot(b.direction) < 0)) return;  // also if an end has no direction
    events_.push({GrowthEvent::Kind::joining, way.norm(), first, second});
  }

  void add_intersection(std::size_t first, std::size_t second) {
    const GrowingEnd &a = ends_[first], &b = ends_[second];
    if (a.right != b.left || a.left == b.right) return;
    const auto point = find_intersection(a, b);
    if (!point) return;
    if (rules_.require_equidistance && !accept_branch(input_, a, b, *point)) return;
    events_.push({GrowthEvent::Kind::intersection, branch_distance(a, b, *point), first, second, *point});
  }

  /// Adds an end that enters the face beyond halfedge h, at a node at parameter t of h's twin. It continues `end`,
  /// whose images are in the plane of h's face.
  void enter(HalfedgeId h, double t, int node, const GrowingEnd& end) {
    const HalfedgeId twin = mesh_.twin(h);
    const auto old_plane = FaceLayout(mesh_, Mesh::face(h)).corner,
               new_plane = FaceLayout(mesh_, Mesh::face(twin)).corner;
    const int i = Mesh::corner(h), j = Mesh::corner(twin);
    const Vec2 &a = new_plane[j], &b = new_plane[(j + 1) % 3];
    const EdgeRotation rotate(old_plane[(i + 1) % 3], old_plane[i], a, b);
    const FaceId f = Mesh::face(twin);
    const Vec2 left = image_in(f, new_plane, end.left, rotate(end.left_image));
    const Vec2 right = image_in(f, new_plane, end.right, rotate(end.right_image));
    GrowingEnd next{f, node, a + t * (b - a), end.left, end.right, left, right};
    if (rules_.direction == GrowthRules::Direction::of_segment) next.direction = rotate.turn(end.direction);
    add_end(std::move(next), new_plane);
  }

  Vec2 image_in(FaceId f, const std::array<Vec2, 3>& plane, GeneratorId g, const Vec2& rotated) const {
    if (rules_.images == GrowthRules::Images::rotated) return rotated;
    const auto distances = table_distances(input_, f, g);
    return distances ? unfold_generator(plane, *distances) : rotated;
  }

  void deactivate(std::size_t end) {
    ends_[end].active = false;
    --active_;
  }

  /// Ends the arc that `end` grew at a node.
  void add_arc(std::size_t end, int to) {
    const GrowingEnd& e = ends_[end];
    grown_.arcs.push_back({e.face, e.node, to, e.left, e.right});
    deactivate(end);
  }

  /// Replaces two ends that intersect by one end between the two outer generators.
  void merge(const GrowthEvent& at) {
    const GrowingEnd a = ends_[at.first], b = ends_[at.second];
    const FaceLayout layout(mesh_, a.face);
    const int node = add_node({GapNode::Kind::branch, CrossingId(), {}, a.face, layout.bary(at.point), at.distance});
    add_arc(at.first, node);
    add_arc(at.second, node);
    add_end({a.face, node, at.point, a.left, b.right, a.left_image, b.right_image}, layout.corner);
  }

  /// Continues an end in the next face. Returns false if the exit is too close to a vertex, or leaves the gap, because
  /// all bisectors that cross the rim have an end there already.
  bool leave_face(std::size_t leaver) {
    const Exit exit = *ends_[leaver].exit;
    if (exit.t < kCrossingGap || exit.t > 1 - kCrossingGap) return false;
    const HalfedgeId twin = mesh_.twin(exit.halfedge);
    if (is_rim(mesh_, gap_, exit.halfedge)) {
      entered_ = Mesh::face(twin);
      return false;
    }
    const int node =
        add_node({GapNode::Kind::crossing, CrossingId(), crossing_at(exit, ends_[leaver]), FaceId(), {}, 0});
    add_arc(leaver, node);
    if (twin.valid()) enter(exit.halfedge, 1 - exit.t, node, ends_[leaver]);
    return true;
  }

  Crossing crossing_at(const Exit& exit, const GrowingEnd& end) const {
    const EdgeId e = mesh_.edge(exit.halfedge);
    const bool along = mesh_.halfedge(e) == exit.halfedge;
    // On the way out of the face, the beginning of its halfedge lies on the right.
    return {e, along ? exit.t : 1 - exit.t, along ? end.right : end.left, along ? end.left : end.right};
  }

  const GrowthInput& input_;
  const Mesh& mesh_;
  const Crossings& crossings_;
  const Gap& gap_;
  const GrowthRules& rules_;
  std::vector<GrowingEnd> ends_;
  std::size_t active_ = 0;  // number of active ends
  GrowthEvents events_;
  GrownGap grown_;
  FaceId entered_;  // face outside the gap that an end wants to enter
};

}  // namespace

GrowthOutcome grow_bisectors(const GrowthInput& input, const Crossings& crossings, const Gap& gap,
                             const GrowthRules& rules) {
  if (gap.faces.size() > kMaxGapFaces) return {};
  GrowthOutcome outcome = EventLoop(input, crossings, gap, rules).run();
  if (outcome.grown && !check_growth(input.working, input.labels, crossings, gap, *outcome.grown)) return {};
  return outcome;
}

}  // namespace gvd
