// Edits of diagrams as calls: the bytes of new diagrams, whichever diagram is edited, and refusals that change nothing.

#include <array>
#include <string>
#include <thread>
#include <vector>

#include "gvd/error.hpp"
#include "operations/calls.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/same_diagram.hpp"

namespace gvd::test_edit_operation {

using Catch::Matchers::Contains;
using gvd::test::call;
using gvd::test::diagram_of;
using gvd::test::ObjectPtr;
using gvd::test::part_of;
using gvd::test::Recorder;

const MeshPtr kBall = std::make_shared<const CheckedMesh>(as_input(test::make_bumpy_sphere(4, 7)));

ObjectPtr of_ball(const char* operation, const std::string& options) {
  return call(operation, std::make_shared<MeshObject>(kBall), options);
}

ObjectPtr edit(const ObjectPtr& on, const std::string& options) { return call("edit", on, options); }

/// Whether it is the diagram that its generators have, to the last bit.
bool is_new(const ObjectPtr& object) {
  return test::same_diagram(diagram_of(object), compute_diagram(kBall->mesh, diagram_of(object).generators));
}

std::int32_t propagated(const ObjectPtr& object) {
  struct Reader : ObjectVisitor {
    void figure(const Meaning& meaning, const Figure& value) override {
      if (meaning.name == "propagated") found = std::int32_t(std::get<std::int64_t>(value));
    }
    std::int32_t found = -1;
  } reader;
  object->visit(reader);
  return reader.found;
}

TEST_CASE("edits have the bytes of new diagrams, and the diagrams before stay") {
  const ObjectPtr first = of_ball("diagram", R"({"count": 60, "editable": true})");
  CHECK(is_new(first));
  const Diagram kept = diagram_of(first);
  const ObjectPtr moved = edit(first, R"({"move": 7, "to": [123]})");
  CHECK(is_new(moved));
  CHECK(vertex(kBall->mesh, diagram_of(moved).generators[7]) == VertexId(123));
  const ObjectPtr more = edit(moved, R"({"add": [5, 900]})");
  CHECK(is_new(more));
  CHECK(diagram_of(more).generators.size() == 62);
  const ObjectPtr fewer = edit(more, R"({"remove": 3})");
  CHECK(is_new(fewer));
  CHECK(diagram_of(fewer).generators[3] == diagram_of(more).generators[61]);  // the last one has its number
  CHECK(test::same_diagram(diagram_of(first), kept));
  for (const ObjectPtr& one : {moved, fewer}) CHECK(propagated(one) < 40);
}

TEST_CASE("a diagram that was edited before can be edited again, and so can diagrams of results") {
  const ObjectPtr first = of_ball("diagram", R"({"count": 9, "chord_tolerance": 0.01})");
  DiagramOptions coarse;
  coarse.chord_tolerance = 0.01;
  for (int i = 0; i < 2; ++i) {
    const ObjectPtr moved = edit(first, R"({"move": 2, "to": [77]})");
    CHECK(test::same_diagram(diagram_of(moved), compute_diagram(kBall->mesh, diagram_of(moved).generators, coarse)));
  }
  for (const auto& [operation, options] :
       {std::pair{"segment", R"({"count": 12})"}, {"lloyd", R"({"count": 12})"}, {"remesh", R"({"count": 40})"}}) {
    CAPTURE(operation);
    CHECK(is_new(edit(part_of(of_ball(operation, options), "diagram"), R"({"remove": 0})")));
  }
}

TEST_CASE("two threads may edit one diagram at once") {
  const ObjectPtr first = of_ball("diagram", R"({"count": 20, "editable": true})");
  std::array<ObjectPtr, 2> made;
  std::array<std::thread, 2> threads;
  for (std::size_t i = 0; i < 2; ++i) {
    threads[i] =
        std::thread([&, i] { made[i] = edit(first, i == 0 ? R"({"remove": 1})" : R"({"move": 1, "to": [8]})"); });
  }
  for (std::thread& thread : threads) thread.join();
  for (const ObjectPtr& one : made) CHECK(is_new(one));
}

TEST_CASE("an edit that is refused or interrupted changes nothing") {
  const ObjectPtr first = of_ball("diagram", R"({"count": 12, "editable": true})");
  CHECK_THROWS_WITH(edit(first, R"({"move": 12, "to": [0]})"),
                    Contains("there is no generator 12; the diagram has 12 generators"));
  CHECK_THROWS_WITH(edit(first, R"({"remove": 12})"), Contains("there is no generator 12"));
  CHECK_THROWS_WITH(edit(first, R"({"move": 1, "to": [0, 1]})"),
                    Contains("one point is needed in to, and there are 2"));
  CHECK_THROWS_WITH(edit(first, R"({"move": 1, "to": [999999]})"), Contains("there is no vertex 999999"));
  CHECK_THROWS_WITH(edit(first, R"({"add": [{"position": [0, 0, 9]}], "max_snap": 1})"), Contains("from the surface"));
  CHECK_THROWS_WITH(edit(of_ball("diagram", R"({"vertices": [5]})"), R"({"remove": 0})"),
                    "generator 0 is the only one, and a diagram needs one; move it, or add another first");
  CHECK_THROWS_WITH(edit(first, R"({"add": [4, 4]})"), Contains("twice"));
  CHECK_THROWS_WITH(edit(first, "{}"), Contains("no change: give one of"));
  CHECK_THROWS_WITH(edit(first, R"({"move": 1})"), Contains("to"));
  CHECK_THROWS_WITH(edit(first, R"({"move": 1, "to": [0], "remove": 2})"), Contains("exclude each other"));
  Recorder stopping;
  stopping.cancels = true;
  CHECK_THROWS_AS(call("edit", first, R"({"move": 1, "to": [0]})", stopping), Error);
  CHECK(stopping.depth == 0);
  const ObjectPtr moved = edit(first, R"({"move": 1, "to": [0]})");
  CHECK(is_new(moved));
  const ObjectPtr one =
      edit(edit(of_ball("diagram", R"({"count": 2})"), R"({"remove": 0})"), R"({"move": 0, "to": [9]})");
  CHECK_THROWS_WITH(edit(one, R"({"remove": 0})"), Contains("generator"));
}

TEST_CASE("diagrams of other methods, with weights, of curves and inside regions can't be edited") {
  const auto refused = [](const ObjectPtr& on, const char* why) {
    CHECK_THROWS_WITH(edit(on, R"({"remove": 0})"), Contains(why));
  };
  refused(of_ball("diagram", R"({"count": 5, "method": "gbgvd"})"), "exact method");
  refused(of_ball("diagram", R"({"count": 5, "balance": "area"})"), "with weights can't be edited");
  refused(of_ball("diagram", R"({"curves": {"points": [3, 90]}})"), "of curves can't be edited");
  refused(part_of(of_ball("segment", R"({"levels": [2, 5]})"), "diagram"), "inside regions can't be edited");
  CHECK_THROWS_WITH(of_ball("diagram", R"({"count": 5, "editable": true, "method": "gbgvd"})"), Contains("needs"));
}

}  // namespace gvd::test_edit_operation
