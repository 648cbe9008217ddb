// Several inputs of one call: a run and outputs for each, and one table.

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "apps/require_error.hpp"
#include "apps/run_command.hpp"
#include "support/catch.hpp"

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

TEST_CASE("several inputs: each has its outputs, a failed one does not stop the rest, and a table ends the run") {
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
    CHECK(line_count(table) == 4);
    CHECK_THAT(table, Contains("torus.ply") && Contains("failed (3: unreadable input)") && EndsWith(" s\n"));
    CHECK_THAT(table, Contains("regions") && Contains(name == "gvd-lloyd" ? "energy" : "time"));
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
    for (const char* option : {" -o a.ply", " --report a.json", " --diagram a.json", " --view a.html"}) {
      require_error(name, inputs.all + inputs.to_out + option, 2, " excludes ");
    }
    require_error(name, "- --input-format off" + inputs.to_out, 2, "standard input has no name");
    require_error(name, inputs.all + " --generators - --output-dir " + inputs.out, 2, "name a file");
    require_error(name, inputs.all + inputs.to_out + "/none/x", 6, "create it first");
    require_error(name, inputs.good + " -n 9 --output-format off --output-dir " + inputs.scratch / "", 2,
                  "the run reads this file");
    require_error(name, inputs.good + inputs.to_out + " --output-format off,bmp", 2,
                  "--output-format: 'bmp' is not one of ");
    require_error(name, inputs.good + " -n 9 -o - --output-format off,ply", 2, "-o - writes one format");
  }
  require_error("gvd-segment", inputs.all + inputs.to_out + " --stats a.csv", 2, " excludes ");
  CHECK(!fs::exists(inputs.out));
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
