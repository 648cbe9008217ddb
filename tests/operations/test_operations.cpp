// Every operation by its table: described in full, run with options as JSON, cancelled.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "gvd/distances_operation.hpp"
#include "gvd/error.hpp"
#include "gvd/io/format.hpp"
#include "gvd/operation.hpp"
#include "gvd/operation_json.hpp"
#include "gvd/polygon_soup.hpp"
#include "gvd/soup.hpp"
#include "operations/recorder.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_operations {

using Catch::Matchers::Contains;
using gvd::test::Recorder;
using Json = nlohmann::ordered_json;

const MeshPtr kBall = std::make_shared<const CheckedMesh>(as_input(test::make_sphere(2)));

const auto kBallObject = std::make_shared<const MeshObject>(kBall);

std::shared_ptr<const Object> made_of_ball(std::string_view operation) {
  Recorder told;
  const auto call = find_operation(operation)->call();
  OptionList list;
  call->describe(list);
  read_json_options(list, *kBall, R"({"count": 8})", {});
  return call->run(kBallObject, told);
}

std::string usual_options(std::string_view operation) {
  return operation == "distances"                     ? R"({"from": [0]})"
         : operation == "label"                       ? "{}"
         : operation == "edit"                        ? R"({"remove": 0})"
         : operation == "curves"                      ? R"({"curves": {"points": [0, 5]}})"
         : operation == "map" || operation == "check" ? "{}"
         : operation == "scene"                       ? "{}"
                                                      : R"({"count": 8})";
}

std::shared_ptr<const Object> call(const Operation& operation, const std::string& options, Recorder& told) {
  const auto made = operation.call();
  OptionList list;
  made->describe(list);
  read_json_options(list, *kBall, options, {});
  return made->run(
      operation.on == "mesh" ? kBallObject : made_of_ball(operation.name == "scene" ? "diagram" : operation.on), told);
}

/// The names of all parts of an object, and whether each figure has a value.
struct Names : ObjectVisitor {
  void figure(const Meaning& meaning, const Figure&) override { add(meaning); }
  void array(const Meaning& meaning, const ArrayView&) override { add(meaning); }
  void points(const Meaning& meaning, const PointsView&) override { add(meaning); }
  void curves(const Meaning& meaning, const PointLists&) override { add(meaning); }
  void table(const Meaning& meaning, const Table&) override { add(meaning); }
  void part(const Meaning& meaning, std::string_view, const PartMaker&) override { add(meaning); }
  void add(const Meaning& meaning) {
    CHECK(!meaning.text.empty());
    names.emplace_back(meaning.name);
  }
  std::vector<std::string> names;
};

std::vector<std::string> names_of(const Object& object) {
  Names names;
  object.visit(names);
  return names.names;
}

TEST_CASE("operations: no rule and no text names an option that is not there") {
  for (const Operation& operation : operations()) {
    const auto made = operation.call();
    OptionList list;
    made->describe(list);
    CAPTURE(operation.name);
    CHECK(list.find_unknown_names().empty());
  }
}

TEST_CASE("operations: each result has the parts that an empty one describes") {
  for (const Operation& operation : operations()) {
    if (operation.on.empty()) continue;  // of files and arrays
    CAPTURE(operation.name);
    Recorder told;
    const auto made = call(operation, usual_options(operation.name), told);
    CHECK(made->kind() == operation.no_result()->kind());
    CHECK(names_of(*made) == names_of(*operation.no_result()));
    CHECK(told.depth == 0);
    CHECK((!told.steps.empty() || operation.name == "check"));
    CHECK(Json::parse(figures_json(*made)).is_object());
  }
}

TEST_CASE("operations: a progress that says stop cancels each one, and its steps end") {
  for (const Operation& operation : operations()) {
    if (operation.on.empty() || operation.name == "check" || operation.name == "curves") continue;  // quick ones
    CAPTURE(operation.name);
    Recorder told;
    told.cancels = true;
    try {
      call(operation, usual_options(operation.name), told);
      FAIL("it ran to its end");
    } catch (const Error& error) {
      CHECK(error.code() == ErrorCode::interrupted);
    }
    CHECK(told.depth == 0);
  }
}

TEST_CASE("figures are nested at the dots of their names, and a level without any is null") {
  Recorder told;
  const Json plain = Json::parse(figures_json(*call(*find_operation("lloyd"), R"({"count": 8})", told)));
  CHECK(plain["balance"].is_null());
  CHECK(plain["coarse"].is_null());
  CHECK(plain["energies"].size() == plain["iterations"].get<std::size_t>() + 1);
  const Json equal =
      Json::parse(figures_json(*call(*find_operation("lloyd"), R"({"count": 8, "balance": "area"})", told)));
  CHECK(equal["balance"]["masses"].size() == 8);
}

TEST_CASE("rows of distances are held once: their array is the table's own memory") {
  struct Reader : ObjectVisitor {
    void array(const Meaning& meaning, const ArrayView& view) override {
      if (meaning.name == "rows") rows = view;
    }
    ArrayView rows;
  } reader;
  Recorder told;
  const auto made = call(*find_operation("distances"), R"({"from": [0, 5, 9], "each": true})", told);
  made->visit(reader);
  const DistanceRows& rows = dynamic_cast<const DistancesOutcome&>(*made).table.rows;
  CHECK(reader.rows.data == rows.values().data());
  CHECK(reader.rows.shape[0] == 3);
  CHECK(reader.rows.shape[1] == kBall->mesh.vertex_count());
  CHECK(rows[1][5] == 0);
  CHECK(rows[2][0] == Approx(rows[0][9]));
}

TEST_CASE("rows of a mesh with more vertices than its input tell what keeps their sources from each") {
  // Two triangles that meet in one vertex, which becomes two.
  const std::vector<double> at{0, 0, 0, 1, 0, 0, 0, 1, 0, -1, 0, 0, 0, -1, 0};
  const std::vector<std::int64_t> corners{0, 1, 2, 0, 3, 4};
  const auto mesh = std::make_shared<const CheckedMesh>(build_mesh(make_soup(at, corners)));
  REQUIRE(mesh->mesh.vertex_count() == 6);
  REQUIRE(mesh->mesh_vertex.size() == 5);
  const auto call = find_operation("distances")->call();
  OptionList list;
  call->describe(list);
  read_json_options(list, *mesh, R"({"from": [1, 3], "each": true, "mesh_vertices": true})", {});
  Recorder told;
  const auto made = call->run(std::make_shared<const MeshObject>(mesh), told);
  CHECK(dynamic_cast<const DistancesOutcome&>(*made).unreached == 6);
  REQUIRE(!told.notes.empty());
  CHECK_THAT(told.notes.back(), Contains("6 of 12"));
}

/// Returns what an operation says against options; empty where it accepts them.
std::string refusal_of(const char* operation, const std::string& options) {
  const auto made = find_operation(operation)->call();
  OptionList list;
  made->describe(list);
  try {
    read_json_options(list, *kBall, options, {});
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST_CASE("a flag with its default is as if it were not there") {
  CHECK(refusal_of("segment", R"({"count": 5, "merge_coincident": false})").empty());
  CHECK(refusal_of("remesh", R"({"count": 5, "exact_count": false, "refine": true})").empty());
  CHECK_THAT(refusal_of("segment", R"({"count": 5, "merge_coincident": true})"), Contains("exclude each other"));
}

TEST_CASE("weights need the exact method, and each operation with them says so before it begins") {
  for (const char* operation : {"segment", "diagram", "lloyd"}) {
    CAPTURE(operation);
    CHECK_THAT(refusal_of(operation, R"({"count": 5, "method": "gbgvd", "balance": "area"})"),
               Contains("balance needs method=exact"));
  }
}

TEST_CASE("JSON that is nested deeply is refused before it fills the stack") {
  const std::string deep = "{\"vertices\": " + std::string(1'000'000, '[') + std::string(1'000'000, ']') + "}";
  CHECK_THAT(refusal_of("segment", deep), Contains("nested more than 8 deep"));
}

TEST_CASE("curves are the words for them, or points") {
  CHECK(refusal_of("segment", R"({"curves": "creases:30"})").empty());
  CHECK_THAT(refusal_of("segment", R"({"curves": "creasesx"})"), Contains("is none of boundary, creases"));
  CHECK_THAT(refusal_of("segment", R"({"curves": "creases:x"})"), Contains("creases"));
}

TEST_CASE("texts are spelled as JSON has options") {
  CHECK(spell_for_json("\1count\2 or \1features=none\2") == R"("count" or "features": "none")");
  CHECK(spell_for_json("\1count=30\2; \1refine=false\2") == R"("count": 30; "refine": false)");
  const std::string text = "\1count=30\2; \1refine=false\2; \1method=exact\2; \1from\2";
  CHECK(spell_for(Door::python, text) == "count=30; refine=False; method='exact'; points");
  CHECK(spell_for(Door::javascript, text) == "count: 30; refine: false; method: 'exact'; points");
}

TEST_CASE("advice is spelled where the call has its option, and none that excludes it is given") {
  const std::string text = "remove one\1+, or add |merge_coincident\2";
  const auto spelled = [&](std::string_view operation, const char* json) {
    const auto call = find_operation(operation)->call();
    OptionList list;
    call->describe(list);
    return spell_for(Door::python, text, list, read_json_options(list, *kBall, json, {}));
  };
  CHECK(spelled("diagram", R"({"vertices": [0, 1]})") == "remove one, or add merge_coincident");
  CHECK(spelled("distances", R"({"from": [0, 1], "keep_coincident": true})") == "remove one");
  CHECK(spelled("edit", R"({"add": [0]})") == "remove one");
  CHECK(spell_for(Door::python, text) == "remove one");
}

TEST_CASE("what is wrong with a value has the code of its cause, and the option's name once") {
  const auto refused = [](std::string_view operation, const char* json) {
    const auto call = find_operation(operation)->call();
    OptionList list;
    call->describe(list);
    Recorder told;
    try {
      read_json_options(list, *kBall, json, {});
      call->run(kBallObject, told);
    } catch (const Error& error) {
      return std::pair(error.code(), std::string(error.what()));
    }
    return std::pair(ErrorCode::interrupted, std::string());
  };
  using enum ErrorCode;
  CHECK(refused("curves", R"({"curves": {"file": "/no/such"}})") ==
        std::pair(unreadable_input, std::string("curves: /no/such: there is no such file")));
  CHECK(refused("diagram", R"({"vertices": [0, 1], "weights": [1]})") ==
        std::pair(invalid_option, std::string("weights: 1 number for 2 generators; weights takes one for each")));
  CHECK(refused("diagram", R"({"generators": [{"vertex": 1}, [0, 0, 1]]})") ==
        std::pair(invalid_option,
                  std::string("generators: '[0,0,1]' is not an object like the first point; write {\"vertex\": 3} "
                              "or {\"position\": [x, y, z]}")));
  CHECK(refused("diagram", R"({"generators": [1, [0, 0, 1]]})").second.starts_with("generators: '1' is not an object"));
  CHECK(refused("diagram", R"({"generators": [{"vertx": 1}]})").first == invalid_option);
  CHECK(refused("diagram", R"({"generators": [{"vertx": 1}]})").second.rfind("generators") == 0);
  CHECK(refused("distances", R"({"from": [3, 3], "keep_coincident": true})") ==
        std::pair(precondition, std::string("from: vertex 3 is listed twice; remove one, or add merge_coincident")));
  CHECK(refused("distances", R"({"from": [3, 3], "keep_coincident": true, "each": true})").second.empty());
  CHECK(refused("segment", R"({"n": 3})").second == "there is no option \"n\"; did you mean \"count\"?");
  CHECK(refused("distances", R"({"at": 3})").second == "there is no option \"at\"; did you mean \"to\"?");
}

TEST_CASE("whole numbers that JavaScript would round are texts there, and can be given back") {
  const auto seed_of = [](const std::string& json, Door door) {
    const auto call = find_operation("sample")->call();
    OptionList list;
    call->describe(list);
    const Given given = read_json_options(list, *kBall, json, {});
    return Json::parse(options_json(list, given, door))["seed"];
  };
  const std::string big = R"({"count": 2, "seed": 9007199254740993})";
  CHECK(seed_of(big, Door::json) == 9007199254740993);
  CHECK(seed_of(big, Door::javascript) == "9007199254740993");
  CHECK(seed_of(R"({"count": 2, "seed": "9007199254740993"})", Door::javascript) == "9007199254740993");
  CHECK(seed_of(R"({"count": 2, "seed": 7})", Door::javascript) == 7);
}

TEST_CASE("the description has every operation, object and format") {
  const Json described = Json::parse(describe_operations());
  CHECK(described["operations"].size() == operations().size());
  CHECK(described["objects"].contains("mesh"));
  CHECK(described["formats"].size() == formats().size());
  for (const Json& operation : described["operations"]) {
    for (const Json& option : operation["options"]) {
      CAPTURE(option.dump());
      CHECK_THAT(option["help"].get<std::string>(), !Contains("\1"));
      if (option["kind"] == "input file" || option["name"] == "input_format" || option["name"] == "content") continue;
      for (const char* word :
           {" file", "File ", "FILE", "standard input", "as in", "VTP or VTU"}) {  // of a command line
        CHECK_THAT(option["help"].get<std::string>(), !Contains(word));
      }
    }
  }
}

}  // namespace gvd::test_operations
