// gvd-remesh on files: its JSON carries the diagram and the mesh, and a refusal is one line.

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "apps/run_command.hpp"
#include "support/catch.hpp"

using namespace gvd::test;
using Catch::Matchers::Contains;

TEST_CASE("gvd-remesh: JSON carries the diagram, the mesh, and which generators were added") {
  const ScratchFolder scratch;
  const std::string mesh = data_file("torus.ply") + " -q ", path = scratch / "coarse.json";
  const CommandResult result = run_command("gvd-remesh", mesh + "-n 4 -o " + path);
  CAPTURE(result.err);
  REQUIRE(result.exit_code == 0);
  const auto content = nlohmann::json::parse(read_text(path));
  CHECK(content["schema"] == "gvd-diagram/1");
  const auto& coarse = content["remesh"];
  CHECK(coarse["vertices"].size() == content["generators"].size());
  CHECK(coarse["added"].get<std::size_t>() + 4 == content["generators"].size());
  CHECK(coarse["faces"].size() == 2 * coarse["vertices"].size());  // of a torus
  CHECK(coarse["face_points"].size() == coarse["faces"].size());
  for (std::size_t i = 0; i < coarse["vertices"].size(); ++i) {
    CHECK(coarse["vertices"][i] == content["generators"][i]["position"]);
  }
  // As generators it gives the same mesh again, and none has to be added.
  const std::string again = scratch / "again.json";
  REQUIRE(run_command("gvd-remesh", mesh + "--no-refine --generators " + path + " -o " + again).exit_code == 0);
  CHECK(nlohmann::json::parse(read_text(again))["remesh"]["faces"] == coarse["faces"]);
}

TEST_CASE("gvd-remesh: what can't be certified is refused in one line, and nothing is written") {
  const ScratchFolder scratch;
  const std::string path = scratch / "coarse.ply";
  const CommandResult result = run_command("gvd-remesh", data_file("torus.ply") + " -n 2 --no-refine -o " + path);
  CHECK(result.exit_code == 5);
  CHECK(std::count(result.err.begin(), result.err.end(), '\n') == 1);
  CHECK_THAT(result.err, Contains("gvd-remesh: error: the dual of 2 generators is no valid mesh: (2) cell "));
  CHECK(!std::filesystem::exists(path));
}

TEST_CASE("gvd-remesh: a note says why generators were added") {
  const CommandResult one = run_command("gvd-remesh", data_file("torus.ply") + " -n 1");
  CHECK(one.exit_code == 0);
  CHECK_THAT(
      one.err,
      Contains(" generators were added: with the given 1, 1 cell is not a disc, 1 cell has too few neighbours\n"));
  const CommandResult many = run_command("gvd-remesh", data_file("torus.ply") + " -n 100");
  CHECK(many.exit_code == 0);
  CHECK_THAT(many.err, !Contains("were added"));
}

TEST_CASE("gvd-remesh: --no-curves is refused, since its files have no curves") {
  const ScratchFolder scratch;
  const CommandResult result =
      run_command("gvd-remesh", data_file("torus.ply") + " -n 9 --no-curves -o " + scratch / "coarse.obj");
  CHECK(result.exit_code == 2);
  CHECK_THAT(result.err, Contains("--no-curves: the files of gvd-remesh have no curves"));
}
