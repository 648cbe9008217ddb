#pragma once

#include <cstdint>

#include "geodesic/windows/propagation/vertex_events.hpp"
#include "gvd/ids.hpp"

namespace gvd {

/// What waits in the queue of a partition: a halfedge with waiting windows, or a vertex event.
class QueueItem {
 public:
  explicit QueueItem(HalfedgeId h) : value_(h.value()) {}
  explicit QueueItem(VertexEventId event) : value_(~event.value()) {}

  bool is_halfedge() const { return value_ >= 0; }
  HalfedgeId halfedge() const { return HalfedgeId(value_); }
  VertexEventId event() const { return VertexEventId(~value_); }

 private:
  std::int32_t value_;  // a halfedge, or the complement of an event's id
};
static_assert(sizeof(QueueItem) == 4);

}  // namespace gvd
