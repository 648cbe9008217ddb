#include "diagram/growth/growth.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

#include "diagram/growth/check_growth.hpp"
#include "diagram/growth/growing_end.hpp"
#include "geodesic/field/face_layout.hpp"

namespace gvd {
namespace {

/// An end passes a face of its gap a few times at the most; more is a loop that growth can't close.
constexpr std::size_t kStepsPerFace = 4;

/// Larger gaps hold whole cells, and no reliable bisector reaches their inside.
constexpr std::size_t kMaxGapFaces = 200;

class GapGrowth {
 public:
  GapGrowth(const GrowthInput& input, const Crossings& crossings, const Gap& gap)
      : input_(input), mesh_(input.mesh()), crossings_(crossings), gap_(gap) {}

  std::optional<GrownGap> run() {
    start_at_rim();
    std::size_t steps = kStepsPerFace * gap_.faces.size() + 4 * ends_.size();
    while (active_ends() > 0) {
      if (steps-- == 0 || !(join_facing() || merge_meeting() || leave_face())) return std::nullopt;
    }
    return std::move(grown_);
  }

 private:
  struct Meeting {
    std::size_t first, second;  // ends; the cell between them is the first one's right and the second one's left
    Vec2 point;
    double distance;
  };

  std::ptrdiff_t active_ends() const {
    return std::count_if(ends_.begin(), ends_.end(), [](const GrowingEnd& e) { return e.active; });
  }

  /// Every crossing on the rim begins an end; its images come from the face outside, where the bisector is sure.
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
        enter(twin, c.t, node, c.previous, c.next, left, right);
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

  /// An end that enters the face beyond halfedge h, at parameter t of h's twin, with images in the plane of h's face.
  void enter(HalfedgeId h, double t, int node, GeneratorId left, GeneratorId right, const Vec2& left_image,
             const Vec2& right_image) {
    const HalfedgeId twin = mesh_.twin(h);
    const auto old_plane = FaceLayout(mesh_, Mesh::face(h)).corner,
               new_plane = FaceLayout(mesh_, Mesh::face(twin)).corner;
    const auto i = static_cast<std::size_t>(Mesh::corner(h)), j = static_cast<std::size_t>(Mesh::corner(twin));
    const Vec2 &a = new_plane[j], &b = new_plane[(j + 1) % 3];
    const EdgeRotation rotate(old_plane[(i + 1) % 3], old_plane[i], a, b);
    add_end({Mesh::face(twin), node, a + t * (b - a), left, right, rotate(left_image), rotate(right_image)}, new_plane);
  }

  void add_arc(GrowingEnd& end, int to) {
    grown_.arcs.push_back({end.face, end.node, to, end.left, end.right});
    end.active = false;
  }

  /// Two ends of one bisector that come towards each other in one face are one arc.
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

  /// The nearest meeting of two neighbouring bisectors becomes a branch point; the cell between them ends there, and
  /// one bisector grows on between the two outer generators.
  bool merge_meeting() {
    std::optional<Meeting> best;
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      for (std::size_t j = 0; j < ends_.size(); ++j) {
        const GrowingEnd &a = ends_[i], &b = ends_[j];
        if (i == j || !a.active || !b.active || a.face != b.face || a.right != b.left || a.left == b.right) continue;
        const auto point = find_intersection(a, b);
        if (!point) continue;
        const double distance = 0.5 * (a.distance_at(*point) + b.distance_at(*point));
        if (!best || distance < best->distance) best = Meeting{i, j, *point, distance};
      }
    }
    if (best) merge(*best);
    return best.has_value();
  }

  void merge(const Meeting& meeting) {
    GrowingEnd &a = ends_[meeting.first], &b = ends_[meeting.second];
    const FaceLayout layout(mesh_, a.face);
    const auto bary = layout.bary(meeting.point);
    const int node = add_node({GapNode::Kind::branch, CrossingId(), {}, a.face, bary, meeting.distance});
    add_arc(a, node);
    add_arc(b, node);
    add_end({a.face, node, meeting.point, a.left, b.right, a.left_image, b.right_image}, layout.corner);
  }

  /// The nearest exit; false where it leads out of the gap, for all bisectors of the rim have their end there already.
  bool leave_face() {
    std::optional<Exit> best;
    std::size_t leaver = 0;
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      if (!ends_[i].active) continue;
      const auto& exit = ends_[i].exit;
      if (exit && (!best || exit->distance < best->distance)) std::tie(best, leaver) = std::tuple(exit, i);
    }
    if (!best || best->t < kCrossingGap || best->t > 1 - kCrossingGap) return false;
    const HalfedgeId h = best->halfedge, twin = mesh_.twin(h);
    if (twin.valid() && !gap_.contains(Mesh::face(twin))) return false;
    GrowingEnd& end = ends_[leaver];
    const bool along = mesh_.halfedge(mesh_.edge(h)) == h;
    // Walking out of the face, the beginning of its halfedge lies on the right.
    const Crossing crossing{mesh_.edge(h), along ? best->t : 1 - best->t, along ? end.right : end.left,
                            along ? end.left : end.right};
    const int node = add_node({GapNode::Kind::crossing, CrossingId(), crossing, FaceId(), {}, 0});
    if (!twin.valid()) {
      add_arc(end, node);
      return true;
    }
    add_arc(end, node);
    const GrowingEnd from = end;  // by value: the new end may move the list
    enter(h, 1 - best->t, node, from.left, from.right, from.left_image, from.right_image);
    return true;
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
