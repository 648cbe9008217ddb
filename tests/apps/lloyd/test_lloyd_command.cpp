// gvd-lloyd on files: what it writes, and that the other commands read it back.

#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "apps/run_command.hpp"
#include "gvd/io/format.hpp"
#include "support/catch.hpp"

namespace gvd::test_lloyd_command {

using namespace test;
using Catch::Matchers::Contains;

const std::string kVertices = " --vertices 1,30,60,90,120,150,180,210 -q ";

nlohmann::json report_of(const std::string& arguments, const std::string& path) {
  const CommandResult result = run_command("gvd-lloyd", arguments + " --report " + path);
  CAPTURE(arguments, result.err);
  REQUIRE(result.exit_code == 0);
  return nlohmann::json::parse(read_text(path));
}

TEST_CASE("gvd-lloyd: the report tells every iteration, and energies never rise") {
  const ScratchFolder scratch;
  for (const std::string mesh : {"figure.obj", "torus.ply", "half_sphere.off", "plate.stl"}) {
    CAPTURE(mesh);
    const auto report = report_of(data_file(mesh) + kVertices + "--iterations 20", scratch / "report.json");
    CHECK(report["options"]["iterations"] == 20);
    CHECK(report["generators"].size() == 8);
    CHECK(report["diagram"]["cells"] == 8);
    CHECK(report["diagram"]["unresolved_ends"] == 0);
    const auto& results = report["results"];
    const auto energies = results["energies"].get<std::vector<double>>();
    REQUIRE(energies.size() == results["iterations"].get<std::size_t>() + 1);
    for (const char* key : {"largest_moves", "mean_moves", "step_scales", "held_generators", "steps", "methods",
                            "relocated_generators"}) {
      CHECK(results[key].size() + 1 == energies.size());
    }
    for (std::size_t i = 1; i < energies.size(); ++i) CHECK(energies[i] <= energies[i - 1]);
    CHECK(energies.back() < energies.front());
    CHECK_THAT("centroids energy no descent prediction iterations", Contains(results["stop"].get<std::string>()));
  }
}

TEST_CASE("gvd-lloyd: the report names the acceleration, and how the steps of each iteration were found") {
  const ScratchFolder scratch;
  for (const std::string kind : {"lbfgs", "none"}) {
    CAPTURE(kind);
    const auto report =
        report_of(data_file("figure.obj") + kVertices + "--iterations 10 --relocate off --accelerate " + kind,
                  scratch / "report.json");
    CHECK(report["options"]["accelerate"] == kind);
    for (const std::string step : report["results"]["steps"]) {
      CHECK((step == "lloyd" || step == "relocation" || step == kind));
    }
    if (kind != "none") CHECK(report["results"]["steps"].front() == kind);
  }
  const auto usual = report_of(data_file("figure.obj") + kVertices + "--iterations 1", scratch / "report.json");
  CHECK(usual["options"]["accelerate"] == "lbfgs");
}

TEST_CASE("gvd-lloyd: every list that it writes is read back by every command, bit by bit") {
  const ScratchFolder scratch;
  const std::string mesh = data_file("figure.obj");
  const auto path = [&](const std::string& name) { return scratch / name; };
  std::vector<std::string> lists;
  std::string outputs;
  for (const std::string& extension : output_extensions(Content::generators)) {
    lists.push_back("a." + extension);
    outputs += " -o " + path(lists.back());
  }
  const CommandResult result =
      run_command("gvd-lloyd", mesh + kVertices + "--iterations 5" + outputs + " --report " + path("report.json"));
  CAPTURE(result.err);
  REQUIRE(result.exit_code == 0);
  CHECK(lists == std::vector<std::string>{"a.json", "a.csv", "a.txt"});
  lists.emplace_back("report.json");
  for (const std::string& name : lists) {
    CAPTURE(name);
    const std::string from = mesh + " -q --generators " + path(name);
    REQUIRE(run_command("gvd-lloyd", from + " --iterations 0 -o " + path("b.txt")).exit_code == 0);
    CHECK(read_text(path("b.txt")) == read_text(path("a.txt")));
    for (const std::string& command : built_commands()) {
      if (command == "gvd-remesh") continue;  // eight generators may not carry a remesh of this figure
      CHECK(run_command(command, from + " -o " + path("c.ply")).exit_code == 0);
    }
  }
}

TEST_CASE("gvd-lloyd: its page shows the relaxed generators and those of the start") {
  const ScratchFolder scratch;
  const CommandResult result =
      run_command("gvd-lloyd", data_file("figure.obj") + kVertices + "--tolerance 1e-8 --view " + scratch / "v.html");
  if (result.exit_code == 2) {
    WARN("skipped: this build is without the viewer");
    return;
  }
  REQUIRE(result.exit_code == 0);
  const std::string page = read_text(scratch / "v.html");
  CHECK_THAT(page, Contains("<title>gvd-lloyd: figure.obj</title>"));
  for (const char* part : {"\"name\":\"Relaxed\"", "\"name\":\"Start\"", "Energy", "Stopped by"}) {
    CHECK(page.find(part) != std::string::npos);
  }
  const std::size_t begin = page.find('{', page.find("id=\"manifest\""));
  const auto manifest = nlohmann::json::parse(page.substr(begin, page.find("</script>", begin) - begin));
  const auto& scenes = manifest["scenes"];
  REQUIRE(scenes.size() == 12);
  CHECK(scenes[1]["iteration"] == 0);
  for (std::size_t i = 2; i < 12; ++i) {
    CHECK(scenes[i]["name"] == "");
    const int step = int(scenes[i]["iteration"]) - int(scenes[i - 1]["iteration"]);
    CHECK(std::abs(step - int(scenes[0]["iteration"]) / 11.0) <= 1);
  }
  CHECK(scenes[0]["iteration"] > scenes[11]["iteration"]);
}

TEST_CASE("gvd-lloyd: a limit of time ends the relaxation, and a valid result is written") {
  const ScratchFolder scratch;
  const std::string mesh = data_file("figure.obj") + kVertices;
  const auto none = report_of(mesh + "--time-limit 0 -o " + scratch / "a.txt", scratch / "report.json");
  CHECK(none["results"]["stop"] == "time limit");
  CHECK(none["results"]["iterations"] == 0);
  CHECK(none["options"]["time_limit"] == 0.0);
  CHECK(none["diagram"]["unresolved_ends"] == 0);
  const auto ample = report_of(mesh + "--time-limit 1e6 --iterations 2", scratch / "report.json");
  CHECK(ample["results"]["stop"] == "iterations");
  const auto usual = report_of(mesh + "--iterations 2", scratch / "report.json");
  CHECK(usual["options"]["time_limit"].is_null());
  CHECK(usual["results"]["energies"] == ample["results"]["energies"]);
}

TEST_CASE("gvd-lloyd: the trace has a row for the start and for each iteration, and only its seconds differ") {
  const ScratchFolder scratch;
  std::vector<std::string> traces;
  for (const std::string name : {"a.csv", "b.csv"}) {
    const auto report = report_of(data_file("figure.obj") + kVertices + "--iterations 9 --trace " + scratch / name,
                                  scratch / "report.json");
    const auto& results = report["results"];
    std::istringstream lines(read_text(scratch / name));
    std::string line, kept;
    std::getline(lines, line);
    CHECK(line == "iteration,energy,largest_move,mean_move,method,step,seconds");
    std::size_t rows = 0;
    for (double before = 0; std::getline(lines, line); ++rows) {
      std::istringstream fields(line);
      std::vector<std::string> row;
      for (std::string field; std::getline(fields, field, ',');) row.push_back(field);
      REQUIRE(row.size() == 7);
      CHECK(row[0] == std::to_string(rows));
      CHECK(std::stod(row[1]) == results["energies"][rows].get<double>());
      CHECK(std::stod(row[2]) == (rows == 0 ? 0 : results["largest_moves"][rows - 1].get<double>()));
      CHECK(row[5] == (rows == 0 ? "start" : results["steps"][rows - 1].get<std::string>()));
      CHECK(std::stod(row[6]) >= before);
      before = std::stod(row[6]);
      kept += line.substr(0, line.rfind(',')) + '\n';
    }
    CHECK(rows == results["energies"].size());
    traces.push_back(kept);
  }
  CHECK(traces[0] == traces[1]);
}

TEST_CASE("gvd-lloyd: samples have normals, areas and energies, and other extensions are refused") {
  const ScratchFolder scratch;
  const std::string mesh = data_file("figure.obj") + kVertices;
  const auto report = report_of(mesh + "--iterations 3 --points " + scratch / "a.npy", scratch / "report.json");
  const std::string bytes = read_text(scratch / "a.npy");
  CHECK_THAT(bytes.substr(0, 128), Contains("'shape': (8, 12)"));
  REQUIRE(bytes.size() == 128 + 8 * 12 * sizeof(double));
  std::array<double, 8 * 12> values{};
  std::memcpy(values.data(), bytes.data() + 128, sizeof(values));
  double area = 0, energy = 0;
  for (std::size_t i = 0; i < 8; ++i) {
    const auto& generator = report["generators"][i];
    for (std::size_t k = 0; k < 3; ++k) CHECK(values[12 * i + k] == generator["position"][k].get<double>());
    CHECK(values[12 * i + 6] == generator["face"].get<double>());
    for (std::size_t k = 0; k < 3; ++k) CHECK(values[12 * i + 7 + k] == generator["bary"][k].get<double>());
    area += values[12 * i + 10];
    energy += values[12 * i + 11];
  }
  CHECK(area == Approx(report["input"]["area"].get<double>()));
  CHECK(energy == Approx(report["results"]["energies"].back().get<double>()));
  for (const std::string bad : {"a.txt", "a", "a.ply.gz"}) {
    const CommandResult result = run_command("gvd-lloyd", mesh + "--points " + scratch / bad);
    CHECK(result.exit_code == 2);
    CHECK_THAT(result.err, Contains("the extension must be one of .ply, .xyz, .npy"));
  }
}

TEST_CASE("gvd-lloyd: the coefficient of variation of the areas is that of the cells, and relaxation lowers it") {
  const ScratchFolder scratch;
  double before = 0;
  for (const int iterations : {0, 60}) {
    const std::string arguments = data_file("figure.obj") + kVertices + "--iterations " + std::to_string(iterations);
    const auto report = report_of(arguments + " --diagram " + scratch / "d.json", scratch / "report.json");
    const auto diagram = nlohmann::json::parse(read_text(scratch / "d.json"));
    double sum = 0, squares = 0;
    for (const auto& cell : diagram["cells"]) {
      const double area = cell["area"];
      sum += area;
      squares += area * area;
    }
    const double cells = double(diagram["cells"].size()), mean = sum / cells;
    const double variation = report["results"]["area_variation"];
    CHECK(variation == Approx(std::sqrt(squares / cells - mean * mean) / mean));
    if (iterations > 0) CHECK(variation < before);
    before = variation;
  }
}

TEST_CASE("gvd-lloyd: options out of range are usage errors") {
  const std::string mesh = data_file("torus.ply") + kVertices;
  for (const char* bad : {"--iterations -1", "--iterations 1.5", "--tolerance -1", "--tolerance nan",
                          "--move-tolerance x", "--accelerate newton", "--time-limit -1", "--time-limit 1s"}) {
    CAPTURE(bad);
    CHECK(run_command("gvd-lloyd", mesh + bad).exit_code == 2);
  }
}

TEST_CASE("commands: a file of one format may go to a pipe, and one of several is refused there before the work") {
  const ScratchFolder scratch;
  const CommandResult map =
      run_command("gvd-remesh", data_file("figure.obj") + " -n 60 -q --map /dev/stdout -o " + scratch / "coarse.obj");
  CHECK(map.exit_code == 0);
  CHECK(nlohmann::json::parse(map.out).is_object());
  const CommandResult points = run_command(
      "gvd-lloyd", data_file("figure.obj") + " -n 20 --points /dev/stdout -o " + scratch / "generators.txt");
  CHECK(points.exit_code == 2);
  CHECK(points.err ==
        "gvd-lloyd: error: --points: /dev/stdout has no known extension; give a file that ends in .ply, .xyz or "
        ".npy\n");
}

TEST_CASE("gvd-lloyd --points: the samples serve as generators, in faces bit by bit, or as positions") {
  const ScratchFolder scratch;
  const CommandResult relaxed =
      run_command("gvd-lloyd", data_file("figure.obj") + kVertices + "--iterations 3 --points " +
                                   scratch / "samples.ply" + " -o " + scratch / "list.txt");
  REQUIRE(relaxed.exit_code == 0);
  REQUIRE(run_command("gvd-lloyd", data_file("figure.obj") + " -q --generators " + scratch / "list.txt" +
                                       " --iterations 0 --points " + scratch / "samples.xyz")
              .exit_code == 0);
  const auto diagram_of = [&](const std::string& list) {
    const CommandResult result = run_command(
        "gvd-segment", data_file("figure.obj") + " -q --diagram " + scratch / "d.json" + " --generators " + list);
    CAPTURE(list, result.err);
    REQUIRE(result.exit_code == 0);
    return read_text(scratch / "d.json");
  };
  const std::string wanted = diagram_of(scratch / "list.txt");
  CHECK(diagram_of(scratch / "samples.ply") == wanted);
  CHECK(diagram_of("- < " + scratch / "samples.ply") == wanted);
  const auto positions = nlohmann::json::parse(diagram_of(scratch / "samples.xyz"))["generators"];
  const auto exact = nlohmann::json::parse(wanted)["generators"];
  REQUIRE(positions.size() == exact.size());
  for (std::size_t i = 0; i < exact.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK(std::abs(positions[i]["position"][k].get<double>() - exact[i]["position"][k].get<double>()) < 1e-12);
    }
  }
}

}  // namespace gvd::test_lloyd_command
