// The options as the report shows them, and texts of users.

#include <nlohmann/json.hpp>

#include "apps/common/options/parse_options.hpp"
#include "common/options/options.hpp"
#include "support/catch.hpp"

namespace gvd::test_options {

using namespace app;
using gvd::test::parse_options;
using Json = nlohmann::ordered_json;

TEST_CASE("options that are not given are null, or their defaults") {
  CHECK(
      to_json(parse_options({"a.obj", "-n", "30"})).dump() ==
      R"({"input":"a.obj","input_format":null,"on_defect":"repair","weld":null,"n":30,"sampling":"farthest","seed":0,)"
      R"("generators":null,"generators_format":null,"vertices":null,"radius":null,"max_snap":null,"merge_coincident":false,)"
      R"("method":"exact","chord_tolerance":0.0001,"front":null,"threads":0,"verify":false,"max_memory":null,)"
      R"("output":[],"no_curves":false,"ascii_ply":false,"diagram":null,"view":null,"up":null,"report":null})");
}

TEST_CASE("options that are given have their values") {
  const Json json = to_json(parse_options({"-", "--input-format", "off", "--vertices", "3,4", "--method", "gbgvd", "-o",
                                           "a.ply", "-o", "-", "--threads", "2", "--view", "v.html", "--up", "-z"}));
  CHECK(json["input_format"] == "off");
  CHECK(json["n"].is_null());
  CHECK(json["vertices"] == Json({3, 4}));
  CHECK(json["method"] == "gbgvd");
  CHECK(json["chord_tolerance"].is_null());
  CHECK(json["front"] == "circle");
  CHECK(json["output"] == Json({"a.ply", "-"}));
  CHECK(json["threads"] == 2);
  CHECK(json["view"] == "v.html");
  CHECK(json["up"] == "-z");
  for (const std::string name : {"farthest", "random", "vertices", "poisson"}) {
    CHECK(to_json(parse_options({"a.obj", "-n", "3", "--sampling", name}))["sampling"] == name);
  }
  const auto front_of = [](const std::vector<std::string>& more) {
    std::vector<std::string> words{"a.obj", "-n", "3"};
    words.insert(words.end(), more.begin(), more.end());
    return to_json(parse_options(words))["front"];
  };
  CHECK(front_of({"--method", "paper"}) == "planar");
  CHECK(front_of({"--method", "paper", "--front", "circle"}) == "circle");
  CHECK(front_of({"--method", "gbgvd"}) == "circle");
  CHECK(front_of({}).is_null());
  CHECK(to_json(parse_options({"a.obj", "-n", "3", "--method", "paper"}))["method"] == "paper");
  CHECK(to_json(parse_options({"a.obj", "-n", "3", "--sampling", "random"}))["sampling"] == "random");
}

TEST_CASE("an extension is in lower case and has no dot") {
  CHECK(file_extension("a.ply") == "ply");
  CHECK(file_extension("folder.d/A.tar.OBJ") == "obj");
  CHECK(file_extension("a.") == "");
  for (const char* none : {"", "a", "folder.d/a", ".hidden", "-"}) {
    CAPTURE(none);
    CHECK(file_extension(none).empty());
  }
}

TEST_CASE("texts of the user's are printable and short in messages, and keep their letters whole") {
  CHECK(app::printable("-n") == "-n");
  CHECK(app::printable(std::string("a\n\0\x1b", 4) + "\x7f") == "a    ");
  CHECK(app::printable(std::string(61, 'a')) == std::string(60, 'a') + "...");
  CHECK(app::printable("k\u00e4se", 3) == "k\u00e4...");
  CHECK(app::printable("k\u00e4se", 2) == "k...");
}

}  // namespace gvd::test_options
