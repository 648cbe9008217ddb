#include "diagram/growth/growth.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>

#include "diagram/growth/check_growth.hpp"
#include "diagram/growth/growing_end.hpp"
#include "geodesic/field/face_layout.hpp"

namespace gvd {
namespace {

/// Events that are allowed for each face of the gap. A sound growth has a few in each face; more mean a loop.
constexpr std::size_t kStepsPerFace = 4;

/// Larger gaps contain whole cells; the images of their generators become too inaccurate on the way through.
constexpr std::size_t kMaxGapFaces = 200;

class GapGrowth {
 public:
  GapGrowth(const GrowthInput& input, const Crossings& crossings, const Gap& gap)
      : input_(input), mesh_(input.mesh()), crossings_(crossings), gap_(gap) {}

  std::optional<GrownGap> run() {
    start_at_rim();
    std::size_t steps = kStepsPerFace * gap_.faces.size() + 4 * ends_.size();
    while (active_ends() > 0) {
      if (steps-- == 0 || !(join_facing() || merge_intersecting() || leave_face())) return std::nullopt;
    }
    return std::move(grown_);
  }

 private:
  /// Two ends whose bisectors intersect in their face. The cell between them is on the right of the first and on the
  /// left of the second.
  struct Intersection {
    std::size_t first, second;
    Vec2 point;
    double distance;  ///< predicted
  };

  std::ptrdiff_t active_ends() const {
    return std::count_if(ends_.begin(), ends_.end(), [](const GrowingEnd& e) { return e.active; });
  }

  /// Every crossing on the rim starts an end. The images of its generators are unfolded in the face outside the gap,
  /// where only two generators compete.
  void start_at_rim() {
    for (const FaceId f : gap_.faces) {
      for (const BoundaryCrossing& c : boundary_crossings(mesh_, crossings_, f)) {
        const HalfedgeId h = Mesh::halfedge(f, c.corner), twin = mesh_.twin(h);
        if (!twin.valid() || gap_.contains(Mesh::face(twin))) continue;
        const FaceId outside = Mesh::face(twin);
        const auto plane = FaceLayout(mesh_, outside).corner;
        const Vec2 left = unfold_generator(plane, corner_distances(input_, outside, c.previous));
        const Vec2 right = unfold_generator(plane, corner_distances(input_, outside, c.next));
        const int node = add_node({GapNode::Kind::rim, c.id, {}, FaceId(), {}, 0});
        enter(twin, c.t, {outside, node, {}, c.previous, c.next, left, right});
      }
    }
  }

  int add_node(GapNode node) {
    grown_.nodes.push_back(std::move(node));
    return static_cast<int>(grown_.nodes.size()) - 1;
  }

  void add_end(GrowingEnd end, const std::array<Vec2, 3>& plane) {
    end.exit = find_exit(end, plane);
    ends_.push_back(std::move(end));
  }

  /// Adds an end that crosses halfedge h out of h's face, at parameter t of h's twin. The images of `end` are in the
  /// plane of h's face, and are rotated into that of the twin's; its start and face are set here.
  void enter(HalfedgeId h, double t, const GrowingEnd& end) {
    const HalfedgeId twin = mesh_.twin(h);
    const auto old_plane = FaceLayout(mesh_, Mesh::face(h)).corner,
               new_plane = FaceLayout(mesh_, Mesh::face(twin)).corner;
    const auto i = static_cast<std::size_t>(Mesh::corner(h)), j = static_cast<std::size_t>(Mesh::corner(twin));
    const Vec2 &a = new_plane[j], &b = new_plane[(j + 1) % 3];
    const EdgeRotation rotate(old_plane[(i + 1) % 3], old_plane[i], a, b);
    add_end({Mesh::face(twin), end.node, a + t * (b - a), end.left, end.right, rotate(end.left_image),
             rotate(end.right_image)},
            new_plane);
  }

  void add_arc(GrowingEnd& end, int to) {
    grown_.arcs.push_back({end.face, end.node, to, end.left, end.right});
    end.active = false;
  }

  /// Joins the nearest two ends of one bisector that face each other in one face by an arc. False if there are none.
  bool join_facing() {
    double nearest = std::numeric_limits<double>::infinity();
    std::pair<std::size_t, std::size_t> best;
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      for (std::size_t j = i + 1; j < ends_.size(); ++j) {
        const GrowingEnd &a = ends_[i], &b = ends_[j];
        if (!a.active || !b.active || a.face != b.face || a.left != b.right || a.right != b.left) continue;
        const Vec2 way = b.start - a.start;
        if (way.dot(a.direction()) <= 0 || way.dot(b.direction()) >= 0) continue;
        if (way.norm() < nearest) std::tie(nearest, best) = std::tuple(way.norm(), std::pair(i, j));
      }
    }
    if (nearest == std::numeric_limits<double>::infinity()) return false;
    add_arc(ends_[best.first], ends_[best.second].node);
    ends_[best.second].active = false;
    return true;
  }

  /// The intersection event of least predicted distance: a branch point where the cell between two ends is closed.
  /// False if no two ends intersect.
  bool merge_intersecting() {
    std::optional<Intersection> best;
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      for (std::size_t j = 0; j < ends_.size(); ++j) {
        const GrowingEnd &a = ends_[i], &b = ends_[j];
        if (i == j || !a.active || !b.active || a.face != b.face || a.right != b.left || a.left == b.right) continue;
        const auto point = find_intersection(a, b);
        if (!point) continue;
        const double distance = 0.5 * (a.distance_at(*point) + b.distance_at(*point));
        if (!best || distance < best->distance) best = Intersection{i, j, *point, distance};
      }
    }
    if (best) merge(*best);
    return best.has_value();
  }

  /// Replaces the two ends by one between the two outer generators.
  void merge(const Intersection& at) {
    GrowingEnd &a = ends_[at.first], &b = ends_[at.second];
    const FaceLayout layout(mesh_, a.face);
    const auto bary = layout.bary(at.point);
    const int node = add_node({GapNode::Kind::branch, CrossingId(), {}, a.face, bary, at.distance});
    add_arc(a, node);
    add_arc(b, node);
    add_end({a.face, node, at.point, a.left, b.right, a.left_image, b.right_image}, layout.corner);
  }

  /// The exit event of least predicted distance. False if there is none, or if it is too close to a vertex, or if it
  /// leaves the gap: all bisectors that cross the rim have an end there already.
  bool leave_face() {
    GrowingEnd* leaver = nullptr;
    for (GrowingEnd& end : ends_) {
      if (!end.active || !end.exit) continue;
      if (!leaver || end.exit->distance < leaver->exit->distance) leaver = &end;
    }
    if (!leaver || leaver->exit->t < kCrossingGap || leaver->exit->t > 1 - kCrossingGap) return false;
    const HalfedgeId h = leaver->exit->halfedge, twin = mesh_.twin(h);
    if (twin.valid() && !gap_.contains(Mesh::face(twin))) return false;
    cross_edge(*leaver);
    return true;
  }

  /// Ends `end` at a new crossing, and continues it in the next face, if there is one.
  void cross_edge(GrowingEnd& end) {
    const HalfedgeId h = end.exit->halfedge;
    const double t = end.exit->t;
    const bool along = mesh_.halfedge(mesh_.edge(h)) == h;
    // On the way out of the face, the beginning of its halfedge lies on the right.
    const Crossing crossing{mesh_.edge(h), along ? t : 1 - t, along ? end.right : end.left,
                            along ? end.left : end.right};
    const int node = add_node({GapNode::Kind::crossing, CrossingId(), crossing, FaceId(), {}, 0});
    add_arc(end, node);
    if (!mesh_.twin(h).valid()) return;
    GrowingEnd next = end;  // a copy: `enter` adds to the list that `end` is in
    next.node = node;
    enter(h, 1 - t, next);
  }

  const GrowthInput& input_;
  const Mesh& mesh_;
  const Crossings& crossings_;
  const Gap& gap_;
  std::vector<GrowingEnd> ends_;
  GrownGap grown_;
};

}  // namespace

std::optional<GrownGap> grow_gap(const GrowthInput& input, const Crossings& crossings, const Gap& gap) {
  if (gap.faces.size() > kMaxGapFaces) return std::nullopt;
  auto grown = GapGrowth(input, crossings, gap).run();
  if (!grown || !check_growth(input.working, input.labels, crossings, gap, *grown)) return std::nullopt;
  return grown;
}

}  // namespace gvd
