#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <queue>
#include <tuple>
#include <vector>

#include "diagram/growth/growth_input.hpp"
#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// The point where a growing end leaves its face.
struct Exit {
  HalfedgeId halfedge;
  double t;  ///< parameter along the halfedge
  Vec2 point;
  double distance;  ///< predicted, mesh units
};

/// The end of a bisector that grows through a face (section 4.3). Positions are in the plane of the face; an image is
/// the position of a generator that was unfolded into that plane.
struct GrowingEnd {
  FaceId face;
  int node;  ///< the node of the gap where it starts
  Vec2 start;
  GeneratorId left, right;
  Vec2 left_image, right_image;
  Vec2 direction = bisector_direction();  ///< unit vector; not finite where the two images coincide
  std::optional<Exit> exit{};             ///< its exit event, if it has one
  bool active = true;

  /// Unit vector along the bisector of the two images, with the left image on the left.
  Vec2 bisector_direction() const { return turned_left(right_image - left_image).normalized(); }

  /// Predicted distance of a point from the two generators: the mean of the distances to their images.
  double distance_at(const Vec2& p) const { return 0.5 * ((p - left_image).norm() + (p - right_image).norm()); }
};

/// The exit event of an end: the first edge through which its ray leaves the face with these corners. None if the ray
/// runs along an edge or away from the face, or has no direction.
std::optional<Exit> find_exit(const GrowingEnd& end, const std::array<Vec2, 3>& corner);

/// The intersection of two ends in one face, if both reach it before they leave the face (section 4.3, intersection
/// computation). `first` is the left end of the two, so that the cell between them narrows towards the intersection.
std::optional<Vec2> find_intersection(const GrowingEnd& first, const GrowingEnd& second);

/// Predicted distance from a point where two ends meet to its three generators, mesh units: the mean of the distances
/// to their images (section 4.3). `first` is the left end of the two. Each end has an image of the generator between
/// them, whose distance is the mean of the distances to these two images.
double branch_distance(const GrowingEnd& first, const GrowingEnd& second, const Vec2& point);

/// Whether a point where two ends meet may be a branch point: equally far from its three generators, and farther from
/// all other generators in the face's table (section 3, second principle).
///
/// Two distances count as equal if they differ by at most kEquidistance face sides. Cost: O(entries of the table).
bool accept_branch(const GrowthInput& input, const GrowingEnd& first, const GrowingEnd& second, const Vec2& point);

/// The rotation around an edge that takes the plane of one of its faces into the plane of the other (section 4.3).
class EdgeRotation {
 public:
  /// `a` and `b` are the ends of the edge in the old plane, `a_new` and `b_new` in the new one.
  EdgeRotation(const Vec2& a, const Vec2& b, const Vec2& a_new, const Vec2& b_new) : from_(a), to_(a_new) {
    const Vec2 u = (b - a).normalized(), v = (b_new - a_new).normalized();
    cosine_ = u.dot(v);
    sine_ = cross(u, v);
  }
  /// The new position of a point.
  Vec2 operator()(const Vec2& p) const { return to_ + turn(p - from_); }
  /// The new direction of a vector, which keeps its components along the edge and across it: equations (9) and (10).
  Vec2 turn(const Vec2& d) const { return {cosine_ * d.x() - sine_ * d.y(), sine_ * d.x() + cosine_ * d.y()}; }

 private:
  Vec2 from_, to_;
  double cosine_, sine_;
};

/// Stands for the second end of an exit event, which has only one end.
inline constexpr std::size_t kNoEnd = std::numeric_limits<std::size_t>::max();

/// An event of growing ends inside a face (section 4.3).
struct GrowthEvent {
  enum class Kind {
    joining,       ///< two ends of one bisector face each other
    intersection,  ///< two ends meet at `point`: the cell right of the first and left of the second ends there
    exit,          ///< one end reaches an edge of its face
  };
  Kind kind;
  double distance;  ///< predicted distance from the generators, mesh units; for a joining, the distance between the two
                    ///< ends
  std::size_t first, second;  ///< indices of the ends
  Vec2 point = Vec2::Zero();  ///< for an intersection: its position in the plane of the face
};

/// The order in which events are handled.
enum class EventOrder {
  by_kind,      ///< every joining before every intersection, and these before every exit; then by distance
  by_distance,  ///< as in the paper: intersections and exits in one order; joinings, which it doesn't have, come first
};

/// The queue of waiting events. Events that tie come in the order of their ends.
class GrowthEvents {
 public:
  explicit GrowthEvents(EventOrder order) : queue_(Later{order}) {}

  bool empty() const { return queue_.empty(); }
  void push(const GrowthEvent& event) { queue_.push(event); }
  GrowthEvent pop() {
    const GrowthEvent event = queue_.top();
    queue_.pop();
    return event;
  }

 private:
  struct Later {
    EventOrder order;
    int rank(const GrowthEvent& e) const {
      if (e.kind == GrowthEvent::Kind::joining) return 0;
      return order == EventOrder::by_distance ? 1 : static_cast<int>(e.kind);
    }
    bool operator()(const GrowthEvent& a, const GrowthEvent& b) const {
      return std::tuple(rank(a), a.distance, a.first, a.second) > std::tuple(rank(b), b.distance, b.first, b.second);
    }
  };

  std::priority_queue<GrowthEvent, std::vector<GrowthEvent>, Later> queue_;
};

}  // namespace gvd
