// gvd-remesh --map: the points of the vertices, both ways.

#include <cmath>

#include "apps/remesh/run_remesh.hpp"
#include "support/catch.hpp"

namespace gvd::test_map_option {

using namespace test;
using Catch::Matchers::Contains;

TEST_CASE("gvd-remesh --map: each vertex has a point of the other mesh, with weights that sum to 1") {
  const ScratchFolder scratch;
  const std::string notes = run_remesh(data_file("figure.obj") + " -n 200 --map " + scratch / "map.json" +
                                       " --report " + scratch / "report.json");
  CHECK_THAT(notes, Contains("map: one-to-one; vertices are 0.0"));
  const auto map = nlohmann::json::parse(read_text(scratch / "map.json"));
  const auto report = nlohmann::json::parse(read_text(scratch / "report.json"));
  CHECK(map["output_vertices"].size() == report["generators"].size());
  CHECK(map["input_vertices"].size() == report["input"]["vertices"]);
  for (const char* side : {"output_vertices", "input_vertices"}) {
    for (const auto& point : map[side]) {
      const auto& bary = point["bary"];
      REQUIRE((bary[0] >= 0 && bary[1] >= 0 && bary[2] >= 0));
      REQUIRE(std::abs(double(bary[0]) + double(bary[1]) + double(bary[2]) - 1) < 1e-14);
    }
  }
  CHECK(map["one_to_one"] == true);
  CHECK(map["obstacle"].is_null());
  CHECK(report["results"]["map"]["one_to_one"] == true);
  CHECK(map["mean_move"] == report["results"]["map"]["mean_move"]);
  CHECK(map["faces"]["kept"] == report["results"]["map"]["kept_faces"]);
  CHECK(map["faces"]["kept"] > 0.98 * double(report["input"]["faces"]));
}

TEST_CASE("gvd-remesh --map: a vertex that the repair drops has no point") {
  const ScratchFolder scratch;
  write_text(scratch / "mesh.off",
             "OFF\n5 4 0\n0 0 0\n9 9 9\n1 0 0\n0 1 0\n0 0 1\n"
             "3 0 3 2\n3 0 2 4\n3 0 4 3\n3 2 3 4\n");
  run_remesh(scratch / "mesh.off" + " -n 4 --map " + scratch / "map.json");
  const auto points = nlohmann::json::parse(read_text(scratch / "map.json"))["input_vertices"];
  REQUIRE(points.size() == 5);
  CHECK(points[1].is_null());
  CHECK(points[4].is_object());
}

TEST_CASE("gvd-remesh --map: other extensions are refused") {
  const CommandResult result = run_command("gvd-remesh", data_file("figure.obj") + " -n 20 --map map.csv");
  CHECK(result.exit_code == 2);
  CHECK_THAT(result.err, Contains("--map"));
}

}  // namespace gvd::test_map_option
