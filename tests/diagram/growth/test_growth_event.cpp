#include <utility>
#include <vector>

#include "diagram/growth/growth_event.hpp"
#include "support/catch.hpp"

namespace gvd::test_growth_event {

using Kind = GrowthEvent::Kind;

/// The first ends of the events, in the order in which they are handled.
std::vector<std::size_t> order_of(EventOrder order, const std::vector<GrowthEvent>& pushed) {
  GrowthEvents events(order);
  for (const GrowthEvent& e : pushed) events.push(e);
  std::vector<std::size_t> popped;
  while (!events.empty()) popped.push_back(events.pop().first);
  return popped;
}

const std::vector<GrowthEvent> kMixed{{Kind::exit, 1, 0, kNoEnd},      {Kind::intersection, 3, 1, 2},
                                      {Kind::joining, 9, 3, 4},        {Kind::exit, 2, 5, kNoEnd},
                                      {Kind::intersection, 1.5, 6, 7}, {Kind::joining, 8, 8, 9}};

TEST_CASE("events by kind: joinings, intersections, exits, each by distance") {
  CHECK(order_of(EventOrder::by_kind, kMixed) == std::vector<std::size_t>{8, 3, 6, 1, 0, 5});
}

TEST_CASE("events by distance: joinings, then intersections and exits in one order") {
  CHECK(order_of(EventOrder::by_distance, kMixed) == std::vector<std::size_t>{8, 3, 0, 6, 5, 1});
}

TEST_CASE("events that tie come in the order of their ends, however they were pushed") {
  const std::vector<GrowthEvent> ties{
      {Kind::exit, 1, 2, kNoEnd}, {Kind::exit, 1, 0, kNoEnd}, {Kind::exit, 1, 1, kNoEnd}};
  for (const EventOrder order : {EventOrder::by_kind, EventOrder::by_distance}) {
    CHECK(order_of(order, ties) == std::vector<std::size_t>{0, 1, 2});
    CHECK(order_of(order, {ties[1], ties[2], ties[0]}) == std::vector<std::size_t>{0, 1, 2});
  }
}

}  // namespace gvd::test_growth_event
