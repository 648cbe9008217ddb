#pragma once

#include <vector>

#include "geodesic/windows/geometry/propagation_ids.hpp"
#include "geodesic/windows/geometry/vertex_fan.hpp"

namespace gvd {

/// A pseudo-source or a generator that a path has reached, and that will send windows.
struct VertexEvent {
  VertexCopyId vertex;
  bool all_round;  ///< into all directions: a generator, or an ambiguous vertex
  VertexPath path;
};

using VertexEventId = Id<struct VertexEventTag>;

/// The vertex events that wait in the queue of a partition. Ids of events that were taken are used again.
class VertexEvents {
 public:
  VertexEventId add(const VertexEvent& event) {
    if (free_.empty()) free_.push_back(events_.push_back({}));
    const VertexEventId id = free_.back();
    free_.pop_back();
    events_[id] = event;
    return id;
  }
  VertexEvent take(VertexEventId id) {
    free_.push_back(id);
    return events_[id];
  }
  /// Gives the memory back. No event may wait.
  void release() {
    events_ = {};
    free_ = {};
  }

 private:
  IdVector<VertexEventId, VertexEvent> events_;
  std::vector<VertexEventId> free_;
};

}  // namespace gvd
