// Options as JSON: their values in a report, and their description.

#include <nlohmann/json.hpp>

#include "apps/common/options/parse_options.hpp"
#include "common/options/option_json.hpp"
#include "gvd/diagram_options.hpp"
#include "gvd/operation_json.hpp"
#include "support/catch.hpp"

namespace gvd::test_option_json {

using namespace app;
using gvd::test::SharedLine;
using Json = nlohmann::ordered_json;

Json reported(const std::vector<std::string>& arguments) {
  SharedLine line;
  line.parse(arguments);
  resolve(line.options.diagram);
  return Json::parse(options_json(line.list, line.given));
}

TEST_CASE("options that are not given are null, or their defaults") {
  CHECK(
      reported({"a.obj", "-n", "30"}).dump() ==
      R"({"input":["a.obj"],"input_format":null,"on_defect":"repair","weld":null,"drop_smaller_than":null,"count":30,"sampling":"farthest","seed":0,)"
      R"("radius":null,"generators":null,"vertices":null,"max_snap":null,"merge_coincident":false,"generators_format":null,)"
      R"("method":"exact","chord_tolerance":0.0001,"front":null,"threads":0,"max_memory":null,"verify":false,)"
      R"("output":[],"output_dir":null,"output_format":null,"ascii_ply":false,"report":null,"view":null,"open":false,)"
      R"("up":null,"summary":null,"no_curves":false,"diagram":null,"config":null,"quiet":false,"verbose":false})");
}

TEST_CASE("options that are given have their values") {
  const Json json = reported({"-", "--input-format", "off", "--vertices", "3,4", "--method", "gbgvd", "-o", "a.ply",
                              "-o", "-", "--threads", "2", "--view", "v.html", "--up", "-z"});
  CHECK(json["input_format"] == "off");
  CHECK(json["count"].is_null());
  CHECK(json["vertices"] == Json({3, 4}));
  CHECK(json["method"] == "gbgvd");
  CHECK(json["chord_tolerance"].is_null());
  CHECK(json["front"] == "circle");
  CHECK(json["output"] == Json({"a.ply", "-"}));
  CHECK(json["output_format"] == Json({"ply"}));
  CHECK(json["threads"] == 2);
  CHECK(json["view"] == "v.html");
  CHECK(json["up"] == "-z");
  for (const std::string name : {"farthest", "random", "vertices", "poisson"}) {
    CHECK(reported({"a.obj", "-n", "3", "--sampling", name})["sampling"] == name);
  }
  const auto front_of = [](const std::vector<std::string>& more) {
    std::vector<std::string> words{"a.obj", "-n", "3"};
    words.insert(words.end(), more.begin(), more.end());
    return reported(words)["front"];
  };
  CHECK(front_of({"--method", "paper"}) == "planar");
  CHECK(front_of({"--method", "paper", "--front", "circle"}) == "circle");
  CHECK(front_of({"--method", "gbgvd"}) == "circle");
  CHECK(front_of({}).is_null());
}

TEST_CASE("the description of an option says what its help says, in parts") {
  const SharedLine line;
  const Json all = describe_options(line.list);
  const auto find = [&](const std::string& name) {
    for (const Json& one : all) {
      if (one["name"] == name) return one;
    }
    return Json();
  };
  const Json radius = find("radius");
  CHECK(radius["names"] == Json({"--radius"}));
  CHECK(radius["group"] == "Generators (one of -n, --generators, --vertices, --radius)");
  CHECK(radius["kind"] == "number");
  CHECK(radius["range"] == "a finite number above 0");
  CHECK(radius["unit"] == "mesh units");
  CHECK(radius["default"].is_null());
  CHECK(radius["excludes"] == Json({"count", "generators", "vertices", "max_snap", "merge_coincident"}));
  CHECK(find("count")["names"] == Json({"-n", "--count"}));
  CHECK(find("sampling")["choices"] == Json({"farthest", "random", "vertices", "poisson"}));
  CHECK(find("sampling")["default"] == "farthest");
  CHECK(find("generators_format")["needs"] == Json({"generators"}));
  CHECK(find("report")["extensions"] == Json({"json"}));
  CHECK(find("help").is_null());  // no setting
}

}  // namespace gvd::test_option_json
