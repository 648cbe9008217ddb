#pragma once

#include <cstddef>
#include <limits>
#include <queue>
#include <tuple>
#include <vector>

#include "gvd/vec.hpp"

namespace gvd {

/// An end that stands for none: an exit has one end only.
inline constexpr std::size_t kNoEnd = std::numeric_limits<std::size_t>::max();

/// What can happen to growing ends inside a face (section 4.3).
struct GrowthEvent {
  enum class Kind {
    joining,       ///< two ends of one bisector face each other
    intersection,  ///< two ends meet at `point`: the cell right of the first and left of the second ends there
    exit,          ///< one end reaches an edge of its face
  };
  Kind kind;
  double distance;            ///< predicted distance from the generators, mesh units; for a joining, of the two ends
  std::size_t first, second;  ///< indices of the ends
  Vec2 point = Vec2::Zero();  ///< of an intersection, in the plane of the face
};

/// Which event comes first.
enum class EventOrder {
  by_kind,      ///< every joining before every intersection, and these before every exit; then by distance
  by_distance,  ///< as the paper has it: one order for intersections and exits. It knows no joining; these come first
};

/// The waiting events. Events that tie come in the order of their ends.
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
