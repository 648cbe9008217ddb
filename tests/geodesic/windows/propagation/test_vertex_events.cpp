#include "geodesic/windows/propagation/queue_item.hpp"
#include "geodesic/windows/propagation/vertex_events.hpp"
#include "support/catch.hpp"

namespace gvd::test_vertex_events {

TEST_CASE("vertex events are found by their ids, which are used again") {
  VertexEvents events;
  const auto event = [](int vertex) { return VertexEvent{VertexCopyId(vertex), false, {1.0 * vertex, {}, {}}}; };
  const VertexEventId a = events.add(event(10)), b = events.add(event(11));
  CHECK(a != b);
  CHECK(events.take(a).vertex == VertexCopyId(10));
  const VertexEventId c = events.add(event(12));
  CHECK(c == a);
  CHECK(events.take(b).path.distance == 11);
  CHECK(events.take(c).path.distance == 12);
  events.release();
  CHECK(events.take(events.add(event(13))).vertex == VertexCopyId(13));
}

TEST_CASE("a queue item is a halfedge or a vertex event") {
  for (const int i : {0, 1, 1 << 20}) {
    const QueueItem halfedge{HalfedgeId(i)}, event{VertexEventId(i)};
    CHECK(halfedge.is_halfedge());
    CHECK(halfedge.halfedge() == HalfedgeId(i));
    CHECK_FALSE(event.is_halfedge());
    CHECK(event.event() == VertexEventId(i));
  }
}

}  // namespace gvd::test_vertex_events
