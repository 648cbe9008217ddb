#include <clocale>
#include <cmath>
#include <locale>
#include <nlohmann/json.hpp>
#include <sstream>

#include "gvd/generator_list.hpp"
#include "gvd/io/diagram_json.hpp"
#include "io/fixture.hpp"
#include "support/catch.hpp"

namespace gvd::test_diagram_json {

using namespace test;
using Json = nlohmann::ordered_json;

std::vector<std::string> keys(const Json& object) {
  std::vector<std::string> names;
  for (const auto& [name, value] : object.items()) names.push_back(name);
  return names;
}
using Names = std::vector<std::string>;

std::string diagram_text(const Labelled& labelled) {
  std::ostringstream out;
  write_diagram_json(out, labelled.mesh, labelled.diagram);
  return out.str();
}

SurfacePoint to_point(const Json& json) {
  return {FaceId(json["face"].get<int>()), json["bary"].get<std::array<double, 3>>()};
}

TEST_CASE("a diagram's JSON has the contract's keys in its order") {
  const Json json = Json::parse(diagram_text(Labelled()));
  CHECK(keys(json) ==
        Names{"schema", "generators", "branch_points", "bisectors", "cells", "vertex_labels", "vertex_distances"});
  CHECK(json["schema"] == "gvd-diagram/1");
  CHECK(keys(json["generators"][0]) == Names{"face", "bary", "position"});
  CHECK(keys(json["branch_points"][0]) == Names{"face", "bary", "position", "generators", "distance"});
  CHECK(keys(json["bisectors"][0]) == Names{"left", "right", "closed", "ends", "points"});
  CHECK(keys(json["bisectors"][0]["points"][0]) == Names{"face", "bary", "position"});
  CHECK(keys(json["cells"][0]) == Names{"generator", "area", "euler_characteristic", "neighbours", "boundary_loops"});
}

TEST_CASE("a diagram's JSON brings every number back") {
  const Labelled labelled;
  const Diagram& diagram = labelled.diagram;
  const Json json = Json::parse(diagram_text(labelled));
  for (std::size_t i = 0; i < diagram.generators.size(); ++i) {
    CHECK(to_point(json["generators"][i]) == diagram.generators[i]);
    const Vec3 p = position(labelled.mesh, diagram.generators[i]);
    CHECK(json["generators"][i]["position"].get<std::array<double, 3>>() == std::array<double, 3>{p.x(), p.y(), p.z()});
  }
  REQUIRE(json["vertex_labels"].size() == diagram.vertex_label.size());
  for (std::size_t v = 0; v < diagram.vertex_label.size(); ++v) {
    CHECK(json["vertex_labels"][v] == diagram.vertex_label.raw()[v].value());
    const double distance = diagram.vertex_distance.raw()[v];
    if (std::isfinite(distance)) CHECK(json["vertex_distances"][v].get<double>() == distance);
    CHECK(json["vertex_distances"][v].is_null() == !std::isfinite(distance));
  }
  CHECK(to_point(json["branch_points"][0]) == diagram.branch_points[BranchPointId(0)].point);
  CHECK(json["branch_points"][0]["generators"] == Json({0, 1, 2}));
  CHECK(json["branch_points"][0]["distance"].get<double>() == 2.0 / 3);
  CHECK(json["bisectors"].size() == 3);
  CHECK(json["bisectors"][0]["ends"] == Json({0, nullptr}));
  CHECK(json["bisectors"][1]["ends"] == Json({nullptr, 0}));
  CHECK(json["bisectors"][2]["ends"] == Json({nullptr, nullptr}));
  CHECK(json["bisectors"][2]["closed"] == true);
  CHECK(json["bisectors"][2]["points"].size() == 3);
  CHECK(to_point(json["bisectors"][0]["points"][1]) == diagram.bisectors[BisectorId(0)].points[1]);
  CHECK(json["cells"][1]["area"].get<double>() == 1.0 / 3);
  CHECK(json["cells"][1]["neighbours"] == Json({0, 2}));
  CHECK(json["cells"][2]["euler_characteristic"] == 0);
}

TEST_CASE("what is not finite is null, and an empty diagram is valid") {
  Labelled labelled;
  labelled.diagram.branch_points[BranchPointId(0)].distance = 1.0 / 0.0;
  CHECK(Json::parse(diagram_text(labelled))["branch_points"][0]["distance"].is_null());
  labelled.diagram = Diagram();
  CHECK(Json::parse(diagram_text(labelled))["cells"] == Json::array());
}

TEST_CASE("no locale changes a number") {
  struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  const std::string before = diagram_text(Labelled()), obj = to_bytes(Labelled().view(), MeshFormat::obj);
  const std::string old = std::setlocale(LC_ALL, nullptr);
  const std::locale classic = std::locale::global(std::locale(std::locale(), new Comma));
  if (std::setlocale(LC_ALL, "de_DE.UTF-8") == nullptr) WARN("C's own locale not tried: de_DE.UTF-8 is not installed");
  CHECK(diagram_text(Labelled()) == before);
  CHECK(to_bytes(Labelled().view(), MeshFormat::obj) == obj);
  CHECK(parse_generators(before, GeneratorFormat::json, "diagram").entries.size() == 3);
  std::locale::global(classic);
  std::setlocale(LC_ALL, old.c_str());
}

TEST_CASE("generators come back bit for bit out of a diagram") {
  Labelled labelled;
  std::vector<SurfacePoint>& points = labelled.diagram.generators;
  for (int i = 1; i < 500; ++i) {
    points.push_back(make_surface_point(FaceId(i % 24), {0.1 / i, i / 700.0, 1 - 0.1 / i - i / 700.0}));
  }
  const GeneratorList list = parse_generators(diagram_text(labelled), GeneratorFormat::json, "diagram");
  CHECK(resolve_generators(labelled.mesh, list).points == points);
}

}  // namespace gvd::test_diagram_json
