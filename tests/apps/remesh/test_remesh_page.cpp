// The page of gvd-remesh: its pictures and their figures.

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "apps/run_command.hpp"
#include "support/catch.hpp"

namespace gvd::test_remesh_page {

using namespace test;

struct Page {
  nlohmann::json scenes;
  nlohmann::json results;  ///< of the report

  /// The scene of a name; null if there is none.
  nlohmann::json scene(const std::string& name) const {
    for (const auto& scene : scenes) {
      if (scene["name"] == name) return scene;
    }
    return {};
  }
};

/// The page of a run; without scenes where the build has no viewer.
Page page_of(const std::string& arguments) {
  const ScratchFolder scratch;
  const CommandResult run = run_command(
      "gvd-remesh", arguments + " -q --view " + scratch / "a.html" + " --report " + scratch / "report.json");
  CAPTURE(arguments, run.err);
  if (run.exit_code == 2) {
    WARN("skipped: this build is without the viewer");
    return {};
  }
  REQUIRE(run.exit_code == 0);
  const std::string page = read_text(scratch / "a.html");
  const std::size_t begin = page.find('{', page.find("id=\"manifest\""));
  const auto manifest = nlohmann::json::parse(page.substr(begin, page.find("</script>", begin) - begin));
  return {manifest["scenes"], nlohmann::json::parse(read_text(scratch / "report.json"))["results"]};
}

std::string figure(const nlohmann::json& scene, const std::string& name) {
  for (const auto& row : scene["figures"]) {
    if (row[0] == name) return row[1];
  }
  return "";
}

TEST_CASE("gvd-remesh: the page has the report's distances, quality, angles and valences") {
  const Page page = page_of(data_file("torus.ply") + " -n 60");
  if (page.scenes.empty()) return;
  const auto &scene = page.scene("Remesh"), &results = page.results;
  const auto& quality = results["quality"]["output"];
  CHECK(std::stod(figure(scene, "Q, mean")) == Approx(double(quality["q_average"])).margin(5e-4));
  CHECK(std::stod(figure(scene, "Q, least")) == Approx(double(quality["q_min"])).margin(5e-4));
  CHECK(std::stod(figure(scene, "Smallest angle, least")) == Approx(double(quality["angle_min"])).margin(0.05));
  CHECK(std::stod(figure(scene, "Smallest angle, mean")) == Approx(double(quality["angle_min_average"])).margin(0.05));
  const auto& valences = results["valences"]["output"];
  CHECK(figure(scene, "Valences") == valences["least"].dump() + " to " + valences["largest"].dump());
  CHECK(std::stod(figure(scene, "Regular vertices")) == Approx(double(valences["percent_regular"])).margin(0.05));
  const auto ratio = [&](const char* there, const char* kind) {
    const auto& distance = results["distance"];
    return double(distance[there][kind]) / double(distance["input_to_output"]["hausdorff"]);
  };
  const double largest = std::stod(figure(scene, "Input to mesh, largest"));
  CHECK(std::stod(figure(scene, "Input to mesh, RMS")) / largest ==
        Approx(ratio("input_to_output", "rms")).epsilon(0.02));
  CHECK(std::stod(figure(scene, "Mesh to input, largest")) / largest ==
        Approx(ratio("output_to_input", "hausdorff")).epsilon(0.02));
  CHECK(std::stod(figure(scene, "Mesh to input, RMS")) / largest ==
        Approx(ratio("output_to_input", "rms")).epsilon(0.02));
}

TEST_CASE("gvd-remesh: the page shows the remesh over the input, before and after placement") {
  const std::string run = data_file("torus.ply") + " -n 60";
  const Page page = page_of(run), unplaced = page_of(run + " --place generator");
  if (page.scenes.empty()) return;
  const auto names = [](const Page& of) {
    std::string list;
    for (const auto& scene : of.scenes) list += std::string(scene["name"]) + ", ";
    return list;
  };
  CHECK(names(page) == "Remesh, Before placement, Input, Diagram, ");
  CHECK(names(unplaced) == "Remesh, Input, Diagram, ");
  const auto remesh = page.scene("Remesh"), before = page.scene("Before placement"), input = page.scene("Input");
  CHECK(remesh["overlay"]["positions"] == input["positions"]);
  CHECK(before["overlay"]["faces"] == input["faces"]);
  CHECK(input["overlay"]["positions"] == remesh["positions"]);
  CHECK(page.scene("Diagram")["positions"] == input["positions"]);
  CHECK(remesh["faces"] == before["faces"]);
  CHECK(remesh["vertex_generators"] == before["positions"]);
  CHECK(remesh["positions"] != before["positions"]);
}

TEST_CASE("gvd-remesh: distances on the page have one scale, of three RMS distances, and percent of the diagonal") {
  const Page page = page_of(data_file("torus.ply") + " -n 60");
  if (page.scenes.empty()) return;
  const auto& distance = page.results["distance"];
  const double rms = std::max(double(distance["input_to_output"]["rms"]), double(distance["output_to_input"]["rms"]));
  for (const char* name : {"Remesh", "Before placement", "Input"}) {
    const auto shown = page.scene(name)["surface_distance"];
    CHECK(double(shown["scale_end"]) == Approx(3 * rms));
    CHECK(shown["other"] == (std::string(name) == "Input" ? "the remesh" : "the input"));
    CHECK(shown["lattice"]["count"] > 1000);
    CHECK(shown["lattice"]["count"] < 100000);
  }
  const auto remesh = page.scene("Remesh");
  const double largest = 65535 * double(remesh["surface_distance"]["lattice_unit"]);
  CHECK(largest <= double(distance["output_to_input"]["hausdorff_bound"]));
  CHECK(largest > 0.9 * double(distance["output_to_input"]["hausdorff"]));
  const double percent =
      100 * double(distance["output_to_input"]["hausdorff"]) / double(remesh["surface_distance"]["reference"]);
  CHECK(std::stod(figure(remesh, "Mesh to input, largest")) == Approx(percent).epsilon(0.01));
}

TEST_CASE("gvd-remesh: a remesh that is the input has a page") {
  const Page page = page_of(data_file("plate.stl") + " -n 8 --features 40");
  if (page.scenes.empty()) return;
  CHECK(double(page.scene("Remesh")["surface_distance"]["scale_end"]) > 0);
}

}  // namespace gvd::test_remesh_page
