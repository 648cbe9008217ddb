// Diagrams and relaxations inside regions: what one operation keeps to, the others do.

#include <memory>
#include <string>

#include "gvd/error.hpp"
#include "gvd/lloyd_operation.hpp"
#include "operations/calls.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/same_diagram.hpp"

namespace gvd::test_parted_mesh {

using Catch::Matchers::Contains;
using gvd::test::call;
using gvd::test::diagram_of;
using gvd::test::ObjectPtr;
using gvd::test::part_of;

const MeshPtr kBall = std::make_shared<const CheckedMesh>(as_input(test::make_sphere(4)));
const ObjectPtr kOn = std::make_shared<MeshObject>(kBall);

/// The region of a face: 0 below the equator, 1 above.
int region_of(FaceId f) {
  double z = 0;
  for (const VertexId v : kBall->mesh.vertices(f)) z += kBall->mesh.position(v).z();
  return z > 0 ? 1 : 0;
}

/// Options with a number for each face.
std::string with_numbers(const std::string& options, const char* name) {
  std::string text = options.substr(0, options.size() - 1) + ", \"" + name + "\": [";
  for (const FaceId f : kBall->mesh.faces()) text += (f.value() == 0 ? "" : ",") + std::to_string(region_of(f));
  return text + "]}";
}

/// Whether the cells of generators of one region have no vertex inside another one, which is left out if it is not 0.
void check_inside(const Diagram& diagram, bool leaves_out) {
  for (const FaceId f : kBall->mesh.faces()) {
    const GeneratorId g = diagram.face_label[f];
    if (g.valid()) REQUIRE(region_of(diagram.generators[g.index()].face) == region_of(f));
    if (leaves_out && region_of(f) == 1) REQUIRE(!g.valid());
  }
}

TEST_CASE("diagram: within and mask give the diagram of a segmentation") {
  for (const char* name : {"within", "mask"}) {
    CAPTURE(name);
    const std::string options = with_numbers(R"({"count": 12})", name);
    const ObjectPtr made = call("diagram", kOn, options);
    check_inside(diagram_of(made), name == std::string("mask"));
    CHECK(test::same_diagram(diagram_of(made), diagram_of(part_of(call("segment", kOn, options), "diagram"))));
    CHECK_THROWS_WITH(call("edit", made, R"({"remove": 0})"), Contains("inside regions can't be edited"));
  }
}

TEST_CASE("lloyd: generators stay in their regions, and the energy falls") {
  for (const char* name : {"within", "mask"}) {
    CAPTURE(name);
    for (const char* options : {R"({"count": 12})", R"({"count": 12, "balance": "area"})",
                                R"({"vertices": [0, 40, 300], "merge_coincident": true})"}) {
      if (name == std::string("mask") && std::string(options).find("vertices") != std::string::npos) continue;
      CAPTURE(options);
      const ObjectPtr made = call("lloyd", kOn, with_numbers(options, name));
      const auto& outcome = dynamic_cast<const LloydOutcome&>(*made);
      CHECK(outcome.relaxed->final_energy < outcome.relaxed->initial_energy);
      check_inside(outcome.diagram->diagram(), name == std::string("mask"));
      CHECK(outcome.diagram->diagram().vertex_label.size() == std::size_t(kBall->mesh.vertex_count()));
      if (outcome.balanced) CHECK(outcome.balanced->balanced.converged);
    }
  }
}

TEST_CASE("lloyd: one region of all faces changes nothing") {
  std::string options = R"({"count": 12, "within": [0)";
  for (int f = 1; f < kBall->mesh.face_count(); ++f) options += ",0";
  const ObjectPtr made = call("lloyd", kOn, options + "]}"), whole = call("lloyd", kOn, R"({"count": 12})");
  CHECK(test::same_diagram(diagram_of(part_of(made, "diagram")), diagram_of(part_of(whole, "diagram"))));
}

TEST_CASE("lloyd: generators in faces that are left out, and those that would get there, are refused") {
  std::int32_t top = 0;
  for (const VertexId v : kBall->mesh.vertices()) {
    if (kBall->mesh.position(v).z() > kBall->mesh.position(VertexId(top)).z()) top = v.value();
  }
  CHECK_THROWS_WITH(call("lloyd", kOn, with_numbers(R"({"vertices": [)" + std::to_string(top) + "]}", "mask")),
                    Contains("left out"));
  CHECK_THROWS_WITH(call("lloyd", kOn, with_numbers(R"({"count": 9, "features": 30})", "mask")),
                    Contains("features} would put generators into the faces that are left out") ||
                        Contains("features would put generators into the faces that are left out"));
  CHECK_THROWS_WITH(call("lloyd", kOn, with_numbers(R"({"count": 9, "coarse": 100})", "within")),
                    Contains("there is no copy of regions; keep one"));
}

TEST_CASE("what curves can't have is refused with the reason") {
  const auto refused = [](const char* operation, const char* options, const char* why) {
    CHECK_THROWS_WITH(call(operation, kOn, options), Contains(why));
  };
  refused("diagram", R"({"curves": "creases", "balance": "area"})",
          "bisectors with weights are computed between points");
  refused("segment", R"({"curves": "creases", "weights": [1]})", "bisectors with weights are computed between points");
  refused("segment", R"({"curves": "creases", "disc": true})", "the cell of a closed curve is not a disc");
  refused("segment", R"({"curves": "creases", "uv": "flat"})", "charts need points as generators");
  for (const char* operation : {"segment", "diagram", "distances"}) {
    CHECK_THROWS_WITH(call(operation, kOn, with_numbers(R"({"curves": "creases"})", "mask")),
                      Contains("a curve may leave its region; keep one"));
  }
}

}  // namespace gvd::test_parted_mesh
