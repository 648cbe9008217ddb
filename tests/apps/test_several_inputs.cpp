// Several inputs of one call: a run and outputs for each, and one table.

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "apps/require_error.hpp"
#include "apps/run_command.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/sanitized.hpp"
#include "support/simple_obj.hpp"

namespace gvd::test_several_inputs {

using namespace test;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;
namespace fs = std::filesystem;

/// Two meshes that can be read, and one between them that can't.
struct Inputs {
  Inputs() {
    write_text(bad, "this is no mesh\n");
    write_text(good, "OFF 4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n");
  }

  ScratchFolder scratch;
  std::string bad = scratch / "bad.off", good = scratch / "good.off", out = scratch / "out",
              all = data_file("torus.ply") + " " + bad + " " + good, to_out = " -n 9 --output-dir " + out;
};

TEST_CASE(
    "several inputs: each has its outputs, a failed one does not stop the rest, and a table and what was written end "
    "the run") {
  for (const std::string& name : built_commands()) {
    const Inputs inputs;
    const CommandResult result = run_command(name, inputs.all + inputs.to_out + " --output-format json,ply");
    CAPTURE(name, result.err);
    CHECK(result.exit_code == 3);
    CHECK(result.out.empty());
    for (const char* file : {"torus.json", "torus.ply", "good.json", "good.ply"}) {
      CHECK(fs::file_size(inputs.out + "/" + file) > 100);
    }
    CHECK(std::distance(fs::directory_iterator(inputs.out), {}) == 4);
    CHECK_THAT(result.err, Contains(name + ": error: " + inputs.bad));
    const std::string table = result.err.substr(result.err.find(name + ": input "));
    CHECK(line_count(table) == 5);
    CHECK_THAT(table, Contains("torus.ply") && Contains("failed (3: unreadable input)") &&
                          EndsWith(" s\n" + name + ": wrote 4 files to " + inputs.out + "\n"));
    CHECK_THAT(table, Contains("generators") && Contains(name == "gvd-lloyd" ? "energy" : "time"));
  }
}

TEST_CASE("several inputs: a note on an input has its name once") {
  const Inputs inputs;
  const std::string plate = data_file("plate.stl");
  const CommandResult result = run_command("gvd-segment", plate + " " + inputs.good + inputs.to_out);
  CAPTURE(result.err);
  CHECK_THAT(result.err, Contains("gvd-segment: " + plate + ": "));
  CHECK_THAT(result.err, Contains("vertices") && !Contains(plate + ": " + plate));
}

TEST_CASE("several inputs: a run's output is that of the same run alone") {
  const Inputs inputs;
  REQUIRE(run_command("gvd-segment", inputs.good + inputs.to_out + " -q --output-format off").exit_code == 0);
  const CommandResult alone = run_command("gvd-segment", inputs.good + " -n 9 -q -o - --output-format off");
  CHECK(alone.out == read_text(inputs.out + "/good.off"));
  const CommandResult quiet = run_command("gvd-segment", inputs.all + inputs.to_out + " -q");
  CHECK(quiet.exit_code == 3);
  CHECK(line_count(quiet.err) == 1);
}

TEST_CASE("several inputs: a pipe whose reader leaves ends one run without a word") {
  const Inputs inputs;
  fs::create_directory(inputs.out);
  const std::string pipe = inputs.out + "/torus.json";
  REQUIRE(std::system(("mkfifo " + pipe + "; { true < " + pipe + "; } &").c_str()) == 0);
  const CommandResult result =
      run_command("gvd-segment", data_file("torus.ply") + " " + inputs.good + inputs.to_out + " --output-format json");
  CAPTURE(result.err);
  CHECK(result.exit_code == 141);
  CHECK_THAT(result.err, Contains("failed (141: reader gone)") && !Contains("error"));
  CHECK(fs::is_regular_file(inputs.out + "/good.json"));
}

TEST_CASE("several inputs: E is in the table with --verify") {
  const Inputs inputs;
  const CommandResult result = run_command("gvd-segment", inputs.good + inputs.to_out + " --verify");
  if (result.err.find("not part of this build") != result.err.npos) return;
  CHECK_THAT(result.err, Contains(" E  ") && Contains("mesh units^2 (the difference"));
}

TEST_CASE("several inputs: what would be lost or is not clear is refused before the work") {
  const Inputs inputs;
  fs::create_directory(inputs.scratch / "other");
  fs::copy_file(inputs.good, inputs.scratch / "other/good.off");
  const std::string twins = inputs.good + " " + inputs.scratch / "other/good.off";
  for (const std::string& name : built_commands()) {
    require_error(name, inputs.all + " -n 9", 2, "with --output-dir");
    require_error(name, twins + inputs.to_out, 2, "would both write " + inputs.out + "/good.");
    for (const char* option : {" -o a.ply", " --report a.json", " --diagram a.json"}) {
      require_error(name, inputs.all + inputs.to_out + option, 2, " exclude each other");
    }
    require_error(name, inputs.all + inputs.to_out + " --view a.html", 2, "pages are named after the inputs");
    require_error(name, inputs.good + " -n 9 --view", 2, "name a file");
    require_error(name, inputs.good + " -n 9 --summary a.csv", 2, "--summary needs --output-dir");
    require_error(name, inputs.good + inputs.to_out + " --summary a.txt", 2, "the extension must be .csv");
    require_error(name, inputs.good + inputs.to_out + " --summary none/a.csv", 6, "create it first");
    require_error(name, "- --input-format off" + inputs.to_out, 2, "standard input has no name");
    require_error(name, inputs.all + " --generators - --output-dir " + inputs.out, 2, "name a file");
    require_error(name, inputs.all + inputs.to_out + "/none/x", 6, "create it first");
    require_error(name, inputs.good + " -n 9 --output-format off --output-dir " + inputs.scratch / "", 2,
                  "the run reads this file");
    require_error(name, inputs.good + inputs.to_out + " --output-format off,bmp", 2,
                  "--output-format: 'bmp' is not one of ");
    require_error(name, inputs.good + " -n 9 -o - --output-format off,ply", 2, "-o - writes one format");
  }
  require_error("gvd-segment", inputs.all + inputs.to_out + " --stats a.csv", 2, " exclude each other");
  CHECK(!fs::exists(inputs.out));
}

TEST_CASE("several inputs: no run replaces a file that another input refers to, and nothing is written then") {
  const Inputs inputs;
  for (const char* folder : {"out", "out/later"}) fs::create_directory(inputs.scratch / folder);
  // (0, 0, 0), (1, 0, 0), (0, 1, 0) as floats, in a file that is also a summary's name.
  std::string numbers(36, '\0');
  for (const std::size_t at : {12, 28}) numbers.replace(at + 2, 2, "\x80\x3f");
  write_text(inputs.out + "/numbers.csv", numbers);
  const std::string scene = inputs.out + "/scene.gltf", painted = inputs.out + "/later/painted.obj";
  write_text(scene, R"({"asset":{"version":"2.0"},"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
                    R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],)"
                    R"("bufferViews":[{"buffer":0,"byteLength":36}],)"
                    R"("buffers":[{"byteLength":36,"uri":"numbers.csv"}]})");
  const std::string triangle = "usemtl red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  for (const std::string& name : built_commands()) {
    CAPTURE(name);
    require_error(name, inputs.good + " " + scene + inputs.to_out + " --summary " + inputs.out + "/numbers.csv", 2,
                  "--summary " + inputs.out + "/numbers.csv: " + scene + " refers to this file; name another one");
    CHECK(read_text(inputs.out + "/numbers.csv") == numbers);
    CHECK(!fs::exists(inputs.out + "/good.ply"));
  }
  // The materials of a later OBJ, as a whole line, as one of several names, and behind a link.
  write_text(inputs.out + "/mine.mtl", "newmtl red\n");
  fs::create_symlink(inputs.out + "/later", inputs.scratch / "link");
  for (const std::string& names : std::vector<std::string>{"../good.mtl", "other.mtl ../good.mtl"}) {
    write_text(painted, "mtllib " + names + "\n" + triangle);
    for (const std::string& spelling : std::vector{painted, inputs.scratch / "link/painted.obj"}) {
      CAPTURE(names, spelling);
      require_error("gvd-segment", inputs.good + " " + spelling + inputs.to_out + " --output-format obj", 2,
                    "the materials of --output-dir " + inputs.out + "/good.mtl: " + spelling +
                        " refers to this file; name another one");
    }
  }
  CHECK(!fs::exists(inputs.out + "/good.obj"));
  // Its own materials are not written over by an OBJ that keeps them.
  write_text(painted, "mtllib ../painted.mtl\n" + triangle);
  const CommandResult own = run_command(
      "gvd-segment", inputs.good + " " + painted + " -n 1 -q --output-format obj --output-dir " + inputs.out);
  CHECK_THAT(own.err, Catch::Matchers::Equals(""));
  CHECK(own.exit_code == 0);
}

TEST_CASE("several inputs: one that is not there, or is cut off, does not stop the others") {
  const Inputs inputs;
  const std::string cut = inputs.scratch / "cut.gltf";
  write_text(cut, R"({"asset":{"version":"2.0"},"buffers":[{"uri":")");
  const CommandResult result =
      run_command("gvd-segment", inputs.scratch / "none.obj" + " " + cut + " " + inputs.good + inputs.to_out + " -q");
  CHECK(result.exit_code == 3);
  CHECK_THAT(result.err, Contains("none.obj: there is no such file") && Contains("cut.gltf: the scene's description"));
  CHECK(line_count(result.err) == 2);
  CHECK(fs::exists(inputs.out + "/good.ply"));
}

TEST_CASE("several inputs: --view without a name writes a page for each, as that of the same run alone") {
  for (const std::string& name : built_commands()) {
    const Inputs inputs;
    const CommandResult result = run_command(name, inputs.all + inputs.to_out + " --view -q");
    if (result.err.find("not part of this build") != result.err.npos) return;
    CAPTURE(name, result.err);
    CHECK(result.exit_code == 3);
    CHECK(fs::exists(inputs.out + "/good.html"));
    CHECK(!fs::exists(inputs.out + "/bad.html"));
    const std::string alone = inputs.scratch / "alone.html";
    REQUIRE(run_command(name, data_file("torus.ply") + " -n 9 -q --view " + alone).exit_code == 0);
    CHECK(read_text(inputs.out + "/torus.html") == read_text(alone));
  }
}

TEST_CASE("several inputs: a file of options asks for pages by an empty name") {
  const Inputs inputs;
  write_text(inputs.scratch / "o.toml", "view = \"\"\nup = \"z\"\n");
  const CommandResult result =
      run_command("gvd-segment", inputs.good + inputs.to_out + " -q --config " + inputs.scratch / "o.toml");
  if (result.err.find("not part of this build") != result.err.npos) return;
  CHECK(result.exit_code == 0);
  CHECK(fs::exists(inputs.out + "/good.html"));
}

/// The records of a CSV whose fields hold no line breaks.
std::vector<std::vector<std::string>> read_csv(const std::string& path) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(read_text(path));
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string>& fields = rows.emplace_back(1);
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
      const bool twice = quoted && line[i] == '"' && line[i + 1] == '"';
      if (line[i] == ',' && !quoted) {
        fields.emplace_back();
      } else if (line[i] == '"' && !twice) {
        quoted = !quoted;
      } else {
        fields.back() += line[i];
        i += twice ? 1 : 0;
      }
    }
  }
  return rows;
}

TEST_CASE("several inputs: --summary has a row for each, also for one that failed, with the figures of its report") {
  for (const std::string& name : built_commands()) {
    const Inputs inputs;
    const std::string table = inputs.out + "/all.csv", report = inputs.scratch / "r.json";
    fs::copy_file(inputs.bad, inputs.scratch / "a,\"b.off");
    const CommandResult result = run_command(
        name, inputs.all + " '" + inputs.scratch / "a,\"b.off" + "'" + inputs.to_out + " -q --summary " + table);
    CAPTURE(name, result.err);
    CHECK(result.exit_code == 3);
    const auto rows = read_csv(table);
    REQUIRE(rows.size() == 5);
    for (const auto& row : rows) CHECK(row.size() == rows[0].size());
    const auto cell = [&](std::size_t row, const std::string& column) {
      const auto at = std::find(rows[0].begin(), rows[0].end(), column);
      return at == rows[0].end() ? "no column" : rows[row][at - rows[0].begin()];
    };
    CHECK(std::vector(rows[0].begin(), rows[0].begin() + 3) == std::vector<std::string>{"input", "exit_code", "error"});
    CHECK(cell(1, "exit_code") == "0");
    CHECK(cell(2, "input") == inputs.bad);
    CHECK(cell(2, "exit_code") == "3");
    CHECK_THAT(cell(2, "error"), Contains("the first line of an OFF file"));
    CHECK(cell(2, "input.faces").empty());
    CHECK(cell(4, "input") == inputs.scratch / "a,\"b.off");
    REQUIRE(run_command(name, inputs.good + " -n 9 -q --report " + report).exit_code == 0);
    const auto json = nlohmann::json::parse(read_text(report));
    CHECK(cell(3, "input.area") == json["input"]["area"].dump());
    CHECK(cell(3, "diagram.length") == json["diagram"]["length"].dump());
    CHECK(rows[0].back() == "seconds");
    CHECK(
        std::any_of(rows[0].begin(), rows[0].end(), [](const auto& column) { return column.starts_with("results."); }));
  }
}

TEST_CASE("several inputs: an interrupt leaves a summary, with the inputs that have not run") {
  const Inputs inputs;
  setenv("TERM", "xterm", 1);
  const std::string table = inputs.scratch / "all.csv", torus = inputs.scratch / "torus.obj";
  write_simple_obj(torus, make_torus(kSanitized ? 125 : 500, kSanitized ? 50 : 200));
  const StoppedRun stopped = interrupt_at(
      "sampling", "gvd-segment", {torus, inputs.good, "-n", "50000", "--output-dir", inputs.out, "--summary", table});
  CAPTURE(stopped.result.err);
  CHECK(stopped.result.exit_code == 130);
  const auto rows = read_csv(table);
  REQUIRE(rows.size() == 3);
  CHECK(rows[1][0] == torus);
  CHECK(rows[1][1] == "130");
  CHECK_THAT(rows[1][2], Contains("interrupted"));
  CHECK(rows[2][0] == inputs.good);
  CHECK(rows[2][1].empty());
  CHECK(rows[2][2] == "not run");
}

TEST_CASE("several inputs: a summary that can't be written is an error, and the runs go on") {
  const Inputs inputs;
  const std::string full = "/dev/full";
  if (!fs::exists(full)) return;
  const CommandResult result =
      run_command("gvd-segment", data_file("torus.ply") + " " + inputs.good + inputs.to_out + " -q --summary " + full);
  CAPTURE(result.err);
  CHECK(result.exit_code == 6);
  CHECK(line_count(result.err) == 1);
  CHECK(fs::exists(inputs.out + "/good.ply") == fs::exists(inputs.out + "/torus.ply"));
}

TEST_CASE("several inputs: a file of options may list them") {
  const Inputs inputs;
  write_text(inputs.scratch / "o.toml", "input = [\"" + inputs.good + "\", \"" + data_file("torus.ply") +
                                            "\"]\nn = 9\nquiet = true\noutput-dir = \"" + inputs.out + "\"\n");
  const CommandResult result = run_command("gvd-segment", "--config " + inputs.scratch / "o.toml");
  CAPTURE(result.err);
  CHECK(result.exit_code == 0);
  CHECK(fs::exists(inputs.out + "/good.ply"));
  CHECK(fs::exists(inputs.out + "/torus.ply"));
}

}  // namespace gvd::test_several_inputs
