#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "gvd/error.hpp"
#include "gvd/generator_list.hpp"
#include "gvd/io/run_report.hpp"
#include "io/fixture.hpp"
#include "support/catch.hpp"

using namespace gvd;
using namespace gvd::test;
using Json = nlohmann::ordered_json;

namespace {

std::vector<std::string> keys(const Json& object) {
  std::vector<std::string> names;
  for (const auto& [name, value] : object.items()) names.push_back(name);
  return names;
}
using Names = std::vector<std::string>;

RunReport make_report(const Labelled& labelled) {
  RunReport report;
  report.command = "gvd-segment";
  report.version = "0.1.0";
  report.options = R"({"z":1,"input":"a \"b\".obj"})";
  report.seed = std::numeric_limits<std::uint64_t>::max();
  report.input = compute_mesh_summary(labelled.mesh);
  report.defects = {{"flipped_faces", 3}, {"duplicate_faces", 0}};
  for (const SurfacePoint& point : labelled.diagram.generators) {
    report.generators.push_back({point, position(labelled.mesh, point), {}});
  }
  report.generators[1].snap_distance = 0.125;
  report.diagram = summarize_diagram(labelled.diagram);
  report.diagram->relabelled_vertices = 3;
  report.diagram->straightened_faces = 4;
  report.timings_ms = {{"read", 1.5}, {"diagram", 0.1}};
  report.peak_memory_bytes = std::int64_t{1} << 40;
  report.results = R"({"regions":[1,2]})";
  return report;
}

Json to_json(const RunReport& report) {
  std::ostringstream out;
  write_run_report(out, report);
  return Json::parse(out.str());
}

}  // namespace

TEST_CASE("a report has the contract's keys in its order") {
  RunReport report = make_report(Labelled());
  report.diagram->verify = VerifyFigures{0.5, 0.25, 4};
  const Json json = to_json(report);
  CHECK(keys(json) == Names{"schema", "command", "version", "options", "seed", "input", "generators", "diagram",
                            "timings_ms", "peak_memory_bytes", "results"});
  CHECK(keys(json["input"]) == Names{"vertices", "faces", "components", "boundary_loops", "euler_characteristic",
                                     "area", "bbox_diagonal", "defects"});
  CHECK(keys(json["diagram"]) == Names{"branch_points", "bisectors", "length", "cells", "disc_cells", "unresolved_ends",
                                       "relabelled_vertices", "straightened_faces", "verify"});
  CHECK(keys(json["diagram"]["verify"]) == Names{"error_integral", "error_mean", "error_max", "length"});
  CHECK(keys(json["options"]) == Names{"z", "input"});
  CHECK(keys(json["input"]["defects"]) == Names{"flipped_faces", "duplicate_faces"});
  CHECK(keys(json["timings_ms"]) == Names{"read", "diagram"});
}

TEST_CASE("a report's values come back") {
  const Labelled labelled;
  RunReport report = make_report(labelled);
  report.diagram->verify = VerifyFigures{0.5, 0.25, 4};
  const Json json = to_json(report);
  CHECK(json["schema"] == "gvd-report/1");
  CHECK(json["seed"].get<std::uint64_t>() == std::numeric_limits<std::uint64_t>::max());
  CHECK(json["options"]["input"] == "a \"b\".obj");
  CHECK(json["input"]["faces"] == 24);
  CHECK(json["input"]["area"].get<double>() == compute_mesh_summary(labelled.mesh).area);
  CHECK(json["diagram"]["branch_points"] == 1);
  CHECK(json["diagram"]["bisectors"] == 3);
  CHECK(json["diagram"]["cells"] == 3);
  CHECK(json["diagram"]["disc_cells"] == 1);  // of the others one is an annulus, one in two parts
  CHECK(json["diagram"]["unresolved_ends"] == 2);
  CHECK(json["diagram"]["relabelled_vertices"] == 3);
  CHECK(json["diagram"]["straightened_faces"] == 4);
  CHECK(json["diagram"]["verify"]["error_mean"] == 0.125);
  CHECK(json["peak_memory_bytes"] == std::int64_t{1} << 40);
  CHECK(json["results"]["regions"] == Json({1, 2}));
  CHECK_FALSE(json["generators"][0].contains("snap_distance"));
  CHECK(json["generators"][1]["snap_distance"] == 0.125);
  std::ostringstream out;
  write_run_report(out, report);
  const GeneratorList list = parse_generators(out.str(), GeneratorFormat::json, "report");
  CHECK(resolve_generators(labelled.mesh, list).points == labelled.diagram.generators);
}

TEST_CASE("a report without diagram, figures or numbers is valid") {
  const Json empty = to_json(RunReport());
  CHECK(empty["diagram"].is_null());
  CHECK(empty["generators"] == Json::array());
  CHECK(empty["timings_ms"] == Json::object());
  RunReport report = make_report(Labelled());
  CHECK(to_json(report)["diagram"]["verify"].is_null());
  report.diagram->verify = VerifyFigures{0, std::numeric_limits<double>::infinity(), 0};
  CHECK(to_json(report)["diagram"]["verify"]["error_mean"] == 0);
  CHECK(to_json(report)["diagram"]["verify"]["error_max"].is_null());
}

TEST_CASE("options and results must be objects; bytes that are no UTF-8 are replaced") {
  RunReport report;
  for (const char* text : {"", "[]", "1", "{", "{\"a\":}"}) {
    report.options = text;
    CHECK_THROWS_AS(to_json(report), Error);
  }
  report.options = "{}";
  report.command = "a\xff";
  CHECK(to_json(report)["command"] == "a\xEF\xBF\xBD");
}
