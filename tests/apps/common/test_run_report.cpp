#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "common/run.hpp"
#include "gvd/error.hpp"
#include "gvd/generator_list.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_run_report {

using namespace app;
using Json = nlohmann::ordered_json;

using Names = std::vector<std::string>;

Names keys(const Json& object) {
  Names names;
  for (const auto& [name, value] : object.items()) names.push_back(name);
  return names;
}

std::string to_text(const RunReport& report) {
  std::ostringstream out;
  report.write(out);
  return out.str();
}

Json to_json(const RunReport& report) { return Json::parse(to_text(report)); }

const Mesh kMesh = test::make_grid(4, 3);
const std::vector<SurfacePoint> kPoints{vertex_point(kMesh, VertexId(0)),
                                        make_surface_point(FaceId(5), {0.1, 0.2, 0.7}),
                                        edge_point(HalfedgeId(40), 1.0 / 3)};

/// Made by hand: a disc, an annulus, and a cell of two components.
Diagram make_diagram() {
  Diagram diagram;
  diagram.branch_points.resize(1);
  diagram.bisectors.resize(3);
  diagram.cells.push_back({GeneratorId(0), 0.5, 1, 1, 1, {}});
  diagram.cells.push_back({GeneratorId(1), 0.5, 1, 2, 2, {}});
  diagram.cells.push_back({GeneratorId(2), 0.5, 0, 1, 2, {}});
  diagram.length = 4.5;
  diagram.report.unresolved_ends = 2;
  diagram.report.relabelled_vertices = 3;
  diagram.report.straightened_faces = 4;
  diagram.report.straightened_error = 0.5;
  return diagram;
}

DefectReport make_defects() {
  DefectReport defects;
  for (const DefectKind kind : {DefectKind::duplicate_faces, DefectKind::unused_vertices}) {
    defects.defects.push_back({kind, 3, 0, ""});
  }
  return defects;
}

/// A report of which every step of a run has filled its part.
struct Filled {
  Filled() {
    report.at("options") = {{"input", "a \"b\".obj"}, {"step", 1.5}};
    report.set_input(compute_mesh_summary(kMesh), make_defects());
    for (const SurfacePoint& p : kPoints) report.generators().push_back({p, position(kMesh, p), {}});
    report.generators()[1].snap_distance = 0.125;
    report.set_diagram(make_diagram());
    report.set_error_measure({0.5, 0.125, 0.25, 4});
    report.at("timings_ms")["read"] = 1.5;
    report.at("timings_ms")["diagram"] = 0.1;
    report.at("peak_memory_bytes") = std::int64_t{1} << 40;
    report.at("results")["regions"] = {1, 2};
  }
  RunReport report{"gvd-segment", std::numeric_limits<std::uint64_t>::max()};
};

TEST_CASE("a report has the contract's keys in its order") {
  const Json json = to_json(Filled().report);
  CHECK(keys(json) == Names{"schema", "command", "version", "options", "seed", "input", "generators", "diagram",
                            "timings_ms", "peak_memory_bytes", "results"});
  CHECK(keys(json["input"]) == Names{"vertices", "faces", "components", "boundary_loops", "euler_characteristic",
                                     "area", "bbox_diagonal", "defects"});
  CHECK(keys(json["diagram"]) == Names{"branch_points", "bisectors", "length", "cells", "disc_cells", "trivial_faces",
                                       "ordinary_faces", "branching_faces", "gaps", "gaps_grown", "gaps_assembled",
                                       "unresolved_ends", "relabelled_vertices", "straightened_faces",
                                       "straightened_error", "verify"});
  CHECK(keys(json["diagram"]["verify"]) == Names{"error_integral", "error_mean", "error_max", "length", "corrected"});
  CHECK(keys(json["options"]).front() == "input");
  CHECK(keys(json["options"]).back() == "step");
  CHECK(keys(json["input"]["defects"]) ==
        Names{std::string(name_of(DefectKind::duplicate_faces)), std::string(name_of(DefectKind::unused_vertices))});
  CHECK(keys(json["timings_ms"]) == Names{"read", "diagram"});
}

TEST_CASE("a report's values come back") {
  const Json json = to_json(Filled().report);
  CHECK(json["schema"] == "gvd-report/2");
  CHECK(json["command"] == "gvd-segment");
  CHECK(json["seed"].get<std::uint64_t>() == std::numeric_limits<std::uint64_t>::max());
  CHECK(json["options"]["input"] == "a \"b\".obj");
  CHECK(json["input"]["faces"] == 24);
  CHECK(json["input"]["area"].get<double>() == compute_mesh_summary(kMesh).area);
  CHECK(json["diagram"]["branch_points"] == 1);
  CHECK(json["diagram"]["bisectors"] == 3);
  CHECK(json["diagram"]["cells"] == 3);
  CHECK(json["diagram"]["disc_cells"] == 1);
  CHECK(json["diagram"]["length"] == 4.5);
  CHECK(json["diagram"]["unresolved_ends"] == 2);
  CHECK(json["diagram"]["relabelled_vertices"] == 3);
  CHECK(json["diagram"]["straightened_faces"] == 4);
  CHECK(json["diagram"]["straightened_error"] == 0.5);
  CHECK(json["diagram"]["verify"]["error_mean"] == 0.125);
  CHECK(json["peak_memory_bytes"] == std::int64_t{1} << 40);
  CHECK(json["results"]["regions"] == Json({1, 2}));
}

TEST_CASE("the generators of a report read back bit by bit") {
  const std::string text = to_text(Filled().report);
  const Json generators = Json::parse(text)["generators"];
  CHECK_FALSE(generators[0].contains("snap_distance"));
  CHECK(generators[1]["snap_distance"] == 0.125);
  const GeneratorList list = parse_generators(text, GeneratorFormat::json, "report");
  CHECK(resolve_generators(kMesh, list).points == kPoints);
}

TEST_CASE("each member and each generator has a line of its own") {
  const std::string text = to_text(Filled().report);
  CHECK(std::count(text.begin(), text.end(), '\n') == 10 + 3 + 2);
  CHECK_THAT(text, Catch::Matchers::StartsWith("{\"schema\":\"gvd-report/2\",\n\"command\":\"gvd-segment\",\n"));
  CHECK_THAT(text, Catch::Matchers::Contains("\n\"generators\":[\n  {\"face\":0,") &&
                       Catch::Matchers::Contains("}\n],\n\"diagram\":"));
  CHECK_THAT(text, Catch::Matchers::EndsWith(",\n\"results\":{\"regions\":[1,2]}}\n"));
}

TEST_CASE("a report that no step has filled is valid") {
  const Json empty = to_json(RunReport("gvd-test", 0));
  CHECK(empty["diagram"].is_null());
  CHECK(empty["generators"] == Json::array());
  CHECK(empty["timings_ms"] == Json::object());
  CHECK(empty["results"] == Json::object());
}

TEST_CASE("a new diagram drops the measured error, and a new time replaces the old one") {
  Filled filled;
  filled.report.set_diagram(make_diagram());
  filled.report.at("timings_ms")["read"] = 2.5;
  const Json json = to_json(filled.report);
  CHECK(json["diagram"]["verify"].is_null());
  CHECK(json["timings_ms"]["read"] == 2.5);
  CHECK(json["timings_ms"].size() == 2);
}

TEST_CASE("numbers that are not finite are null, bytes that are no UTF-8 are replaced") {
  RunReport report("a\xff", 0);
  report.set_diagram(make_diagram());
  report.set_error_measure({0, 0, std::numeric_limits<double>::infinity(), 0});
  CHECK(to_json(report)["diagram"]["verify"]["error_max"].is_null());
  CHECK(to_json(report)["command"] == "a\xEF\xBF\xBD");
}

TEST_CASE("a stream that fails is an error") {
  std::ostringstream out;
  out.setstate(std::ios::badbit);
  CHECK_THROWS_AS(Filled().report.write(out), Error);
}

}  // namespace gvd::test_run_report
