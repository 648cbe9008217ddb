// Labels of a diagram's faces: as a segmentation gives them at once.

#include <memory>
#include <string>

#include "gvd/error.hpp"
#include "gvd/segment_operation.hpp"
#include "operations/calls.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/same_diagram.hpp"

namespace gvd::test_segment_operation {

using Catch::Matchers::Contains;
using gvd::test::call;
using gvd::test::diagram_of;
using gvd::test::ObjectPtr;
using gvd::test::part_of;

const ObjectPtr kTorus =
    std::make_shared<MeshObject>(std::make_shared<const CheckedMesh>(as_input(test::make_torus(24, 12))));

TEST_CASE("label: disc adds generators as segment does, for whole faces and for pieces") {
  const ObjectPtr diagram = call("diagram", kTorus, R"({"count": 2})");
  for (const std::string& more : {std::string("}"), std::string(R"(, "uv": "flat"})")}) {
    CAPTURE(more);
    const ObjectPtr labelled = call("label", diagram, R"({"disc": true)" + more);
    const ObjectPtr whole = call("segment", kTorus, R"({"count": 2, "disc": true)" + more);
    CHECK(diagram_of(part_of(labelled, "diagram")).generators.size() > 2);
    CHECK(test::same_diagram(diagram_of(part_of(labelled, "diagram")), diagram_of(part_of(whole, "diagram"))));
    CHECK(dynamic_cast<const SegmentOutcome&>(*labelled).face_labels() ==
          dynamic_cast<const SegmentOutcome&>(*whole).face_labels());
  }
  CHECK(diagram_of(diagram).generators.size() == 2);
}

TEST_CASE("label: disc is refused where no generators can be added, with the reason") {
  const auto refused = [](const char* options, const char* why) {
    CHECK_THROWS_WITH(call("label", call("diagram", kTorus, options), R"({"disc": true})"), Contains(why));
  };
  refused(R"({"count": 2, "balance": "area"})", "the generators have weights");
  refused(R"({"curves": {"points": [0, 5]}})", "the generators are curves");
  const ObjectPtr levels = call("segment", kTorus, R"({"levels": [2, 4]})");
  CHECK_THROWS_WITH(call("label", part_of(levels, "diagram"), R"({"disc": true})"), Contains("keeps to regions"));
}

}  // namespace gvd::test_segment_operation
