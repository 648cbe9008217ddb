// The options of the commands: usage errors, help, and files of options.

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "apps/require_error.hpp"
#include "apps/run_command.hpp"
#include "gvd/generator_list.hpp"
#include "gvd/read_soup.hpp"
#include "support/catch.hpp"

namespace gvd::test_command_options {

using namespace test;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

TEST_CASE("commands: help and version go to standard output") {
  for (const std::string& name : built_commands()) {
    const CommandResult help = run_command(name, "--help");
    CHECK(help.exit_code == 0);
    CHECK(help.err.empty());
    for (const char* part :
         {"Examples:", "--generators", "--on-defect", "--config", "--chord-tolerance", "--report", "Exit codes:"}) {
      CHECK_THAT(help.out, Contains(part));
    }
    const CommandResult main = run_command(name, "-h");
    CHECK(main.exit_code == 0);
    CHECK(line_count(main.out) <= 24);  // a screen
    CHECK_THAT(main.out, Contains("-o, --output FILE") && Contains("All options, and examples: " + name + " --help"));
    const CommandResult version = run_command(name, "--version");
    CHECK(version.exit_code == 0);
    CHECK_THAT(version.out, StartsWith(name + " "));
    CHECK(line_count(version.out) == 1);
    CHECK(run_command(name, "--help > /dev/full").exit_code == 6);
    std::istringstream lines(help.out);
    for (std::string line; std::getline(lines, line);) {
      CAPTURE(line);
      CHECK(line.size() <= 80);
    }
    for (const char* group : {"\nInput:\n", "\nGenerators (", "\nComputing:\n", "\nOutput:\n", "\nGeneral:\n"}) {
      CHECK_THAT(help.out, Contains(group));
    }
  }
}

TEST_CASE("commands: a bad option is a usage error") {
  const std::string mesh = data_file("torus.ply");
  for (const std::string& name : built_commands()) {
    require_error(name, "", 2, "INPUT");
    require_error(name, mesh, 2, "no generators");
    require_error(name, mesh + " -n 5 --radius 1", 2, "-n and --radius exclude each other: keep one");
    require_error(name, mesh + " -n five", 2, "five");
    require_error(name, mesh + " -n 5 --method other", 2, "exact|gbgvd");
    require_error(name, mesh + " -n 5 --front planar", 2, "add --method gbgvd");
    require_error(name, mesh + " -n 5 --method gbgvd --chord-tolerance 1e-3", 2, "--chord-tolerance");
    require_error(name, mesh + " -n 5 --chord-tolerance 0", 2, "'0' is not a finite number from 1e-10 on");
    require_error(name, mesh + " -n 5 --chord-tolerance 1e-11", 2,
                  "--chord-tolerance: '1e-11' is not a finite number from 1e-10 on");
    require_error(name, mesh + " -n 5 --no-such-option", 2, "--no-such-option");
    require_error(name, mesh + " -n 5 --smapling random --sed 3", 2,
                  "unknown options: --smapling (did you mean --sampling?), --sed (did you mean --seed?)");
    require_error(name, mesh + " -n 5 -o picture.bmp", 2, "picture.bmp");
    require_error(name, mesh + " -n 5 --report keep.ply", 2, "--report: 'keep.ply': the extension must be .json");
    require_error(name, mesh + " -n 5 --view x.ply", 2, "the extension must be one of .html, .htm");
    require_error(name, mesh + " -n 5 --sampling fartest", 2, "poisson; did you mean farthest?");
    require_error(name, "help", 2, "'help' is not a file; did you mean --help?");
    const bool is_remesh = name == "gvd-remesh";
    require_error(name, mesh + " --faces 500", 2,
                  is_remesh ? "--faces (-n sets the vertices; a closed mesh has about twice as many faces)"
                            : "unknown option: --faces (see");
    require_error(name, mesh + " -n 5 -o - --output-format pyl", 2, "'pyl' is not one of ");
    require_error(name, "- -n 5", 2, "--input-format");
    require_error(name, mesh + " -n 5 --config /nonexistent.toml", 2, "/nonexistent.toml");
  }
}

TEST_CASE("commands: options come from a file too") {
  const ScratchFolder scratch;
  write_text(scratch / "options.toml", "n = 12\nseed = 4\nquiet = true\nreport = \"" + scratch / "r.json" + "\"\n");
  for (const std::string& name : built_commands()) {
    const CommandResult result = run_command(name, data_file("torus.ply") + " --config " + scratch / "options.toml");
    CAPTURE(name, result.err);
    CHECK(result.exit_code == 0);
    CHECK(result.err.empty());
    CHECK(nlohmann::json::parse(read_text(scratch / "r.json"))["options"]["count"] == 12);
  }
}

TEST_CASE("commands: a wrong file of options is refused in one line that has line and key") {
  const ScratchFolder scratch;
  const auto refused = [&](const std::string& text, const std::string& part) {
    write_text(scratch / "o.toml", text);
    for (const std::string& name : built_commands()) {
      require_error(name, data_file("torus.ply") + " --config " + scratch / "o.toml", 2, scratch / "o.toml:" + part);
    }
  };
  refused("n = [ 12\n", "");
  refused("n = 12\nview = true\n", "2:8: view: expected a string");
  refused("n = 12\nn = 13\n", "2:");
  refused("n = 12\ncount = 13\n", "2:1: count: is the same option as n above");
  refused("n = 12\n[output]\nreport = \"r.json\"\n", "2:");
  refused("n = 12\nradius = 0.5\n", "2:1: ");
  refused("n = \"\xff\"\n", "1:");
}

TEST_CASE("commands: what is wrong with an option of a file is told with its place and its key") {
  const ScratchFolder scratch;
  const std::string mesh = data_file("torus.ply"), file = scratch / "o.toml";
  const auto refused = [&](const std::string& name, const std::string& arguments, const std::string& toml, int code,
                           const std::string& part) {
    write_text(file, toml);
    require_error(name, arguments + " --config " + file, code, name + ": error: " + file + part);
  };
  const std::string segment = "gvd-segment", distance = "gvd-distance", work = mesh + " -n 5";
  refused(segment, work, "\noutput = \"a.doc\"\n", 2, ":2:1: output = \"a.doc\": the extension must be one of .ply");
  refused(segment, work, "report = \"none/r.json\"\n", 6, ":1:1: report = \"none/r.json\": there is no directory none");
  refused(segment, work + " -o " + scratch / "a.json", "diagram = \"" + scratch / "a.json" + "\"\n", 2,
          ":1:1: diagram = \"" + scratch / "a.json" + "\": two outputs go there");
  refused(segment, work, "stats = \"-\"\n", 2, ":1:1: stats = \"-\": only output can write to standard output");
  refused(segment, mesh + ' ' + mesh + " -n 5", "output-dir = \"" + scratch / "x" + "\"\nview = \"a.html\"\n", 2,
          ":2:1: view = \"a.html\": with output-dir, pages are named after the inputs");
  refused(segment, work, "within = \"none\"\n", 3, ":1:1: within = \"none\": there is no such file");
  refused(segment, mesh, "curves = \"none\"\n", 3, ":1:1: curves = \"none\": there is no such file");
  refused(segment, mesh, "\n\ncurves = \"boundary\"\n", 4, ":3:1: curves = \"boundary\": the mesh is closed");
  refused(distance, mesh, "from = \"none\"\n", 3,
          ":1:1: from = \"none\": there is no such file; name one that lists points, or write vertices, as in from = "
          "\"3,17,99\"");
  refused(distance, mesh + " --from 0 -o a.ply", "each = true\n", 2, ":1:1: each: .ply, ");
  refused(distance, mesh + " --from 0", "output = \"a.obj\"\n", 2, ":1:1: output = \"a.obj\": .obj holds no distances");
  refused(distance, mesh + " --from 0", "each = true\nisolines = 1\n", 2,
          ":2:1: each and isolines exclude each other: isolines are of the nearest source");
}

TEST_CASE("commands: what only looks like a placeholder in a name or a value is shown as it is") {
  const ScratchFolder scratch;
  for (const std::string& name : built_commands()) {
    require_error(name, "'{option:count}.obj' -n 5", 3, "{option:count}.obj: there is no such file");
    require_error(name, data_file("torus.ply") + " -n '{option:seed}'", 2, "-n: '{option:seed}' is not a whole number");
    require_error(name, data_file("torus.ply") + " -n 5 -o '" + scratch / "{given:seed}.doc'", 2,
                  "{given:seed}.doc: the extension must be");
    // Nothing that a user gives has the characters between which placeholders are.
    require_error(name, "\"$(printf 'a\\1count\\2.obj')\" -n 5", 2, "INPUT: 'a count .obj' has a control character");
    require_error(name, data_file("torus.ply") + " -n 5 -o \"$(printf 'a\\1count\\2.ply')\"", 2,
                  "-o: 'a count .ply' has a control character");
  }
}

TEST_CASE("commands: the command line's generators take the place of those of the file") {
  const ScratchFolder scratch;
  write_text(scratch / "o.toml", "input = \"" + data_file("torus.ply") +
                                     "\"\nn = 12\nsampling = \"random\"\nseed = 3\n" + "quiet = true\nreport = \"" +
                                     scratch / "r.json" + "\"\n");
  write_text(scratch / "g.txt", "1\n30\n60\n");
  for (const std::string& choice : {std::string("--vertices 1,30,60"), "--generators " + scratch / "g.txt"}) {
    const CommandResult result = run_command("gvd-segment", choice + " --config " + scratch / "o.toml");
    CAPTURE(choice, result.err);
    REQUIRE(result.exit_code == 0);
    CHECK(nlohmann::json::parse(read_text(scratch / "r.json"))["generators"].size() == 3);
  }
}

TEST_CASE("commands: the schema of reports has every format of a mesh and of a list") {
  const auto schema = nlohmann::json::parse(read_text(data_file("../docs/schema/gvd-report-2.schema.json")));
  const auto& options = schema["properties"]["options"]["properties"];
  const auto names_of = [&](const char* option) {
    std::vector<std::string> names;
    for (const auto& name : options[option]["enum"]) {
      if (name.is_string()) names.push_back(name);
    }
    return names;
  };
  const auto are = [](const std::vector<std::string>& names, const std::vector<std::string_view>& wanted) {
    return std::equal(names.begin(), names.end(), wanted.begin(), wanted.end());
  };
  CHECK(are(names_of("input_format"), names_in(input_format_names())));
  CHECK(are(names_of("generators_format"), names_in(kGeneratorFormatNames)));
}

}  // namespace gvd::test_command_options
