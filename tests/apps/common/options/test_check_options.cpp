// What is refused before any work starts, and the runs of several inputs.

#include <sys/stat.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "apps/common/options/parse_options.hpp"
#include "apps/run_command.hpp"
#include "common/options/check_options.hpp"
#include "support/catch.hpp"
#include "support/refusal.hpp"

namespace gvd::test_check_options {

using namespace app;
using Catch::Matchers::Contains;
using gvd::test::check_line;
using gvd::test::parse_options;

std::string refusal(const std::vector<std::string>& arguments, ErrorCode code = ErrorCode::invalid_option) {
  CAPTURE(arguments);
  return test::refusal([&] { check_line(arguments); }, code);
}

TEST_CASE("generators come from exactly one option") {
  CHECK_NOTHROW(check_line({"a.obj", "--vertices", "1,2"}));
  CHECK(refusal({"a.obj"}) == "no generators: give one of -n, --generators, --vertices or --radius");
  CHECK(refusal({"a.obj", "-n", "3", "--radius", "1"}) == "-n and --radius exclude each other: keep one");
  CHECK(refusal({"a.obj", "--count", "3", "--radius", "1"}) == "--count and --radius exclude each other: keep one");
  CHECK(refusal({"a.obj", "--vertices", "1", "--generators", "g.txt"}) ==
        "--generators and --vertices exclude each other: keep one");
}

TEST_CASE("a stray word is told as such, with what it may have been meant for") {
  const test::ScratchFolder scratch;
  const std::string mesh = scratch / "a.obj", other = scratch / "b.obj", more = scratch / "c.obj";
  for (const std::string& file : {mesh, other, more}) test::write_text(file, "v 0 0 0\n");
  const auto with = [&](const std::string& word) { return refusal({mesh, word, "-n", "3"}); };
  CHECK(refusal({mesh, "24"}) == "unexpected: '24' is not a file; did you mean -n 24?");
  CHECK(with("24") == "unexpected: '24' is not a file; options begin with a dash");
  CHECK(refusal({mesh, "--vertices", "1", "2"}) ==
        "unexpected: '2' is not a file; --vertices takes commas without blanks, as in 3,17,99");
  CHECK(refusal({"-n", "3", "--", mesh, "-q"}) == "unexpected: '-q' is not a file; put options before --");
  CHECK(with(scratch / "x.ply") ==
        "unexpected: '" + scratch / "x.ply" + "' is not a file; did you mean -o " + scratch / "x.ply" + "?");
  CHECK(with("%") == "unexpected: '%' is not a file; a percentage has no blank before %");
  CHECK(with("cut") == "unexpected: 'cut' is not a file; options begin with a dash");
  CHECK_THAT(with(scratch / ""), Contains("is a directory; did you mean --output-dir "));
  CHECK(refusal({mesh, other, "-n", "3"}) == "2 inputs, " + mesh + " and " + other +
                                                 ": name a folder for their outputs with --output-dir, or write -o " +
                                                 other + " for an output");
  CHECK(refusal({mesh, other, "-n", "3", "-o", "x.ply"}) ==
        "2 inputs, " + mesh + " and " + other + ": name a folder for their outputs with --output-dir");
  CHECK_THAT(refusal({mesh, other, more, "-n", "3"}), Contains("3 inputs, " + mesh + " and 2 others: "));
}

TEST_CASE("standard input needs a format") {
  CHECK_THAT(refusal({"-", "-n", "3"}), Contains("name its format with --input-format ply, obj"));
  CHECK_NOTHROW(check_line({"-", "-n", "3", "--input-format", "off"}));
}

TEST_CASE("an option that the method ignores is refused, with what to do") {
  CHECK_THAT(refusal({"a.obj", "-n", "3", "--front", "planar"}), Contains("add --method gbgvd"));
  CHECK_THAT(refusal({"a.obj", "-n", "3", "--method", "gbgvd", "--chord-tolerance", "1e-3"}),
             Contains("--method gbgvd and --chord-tolerance exclude each other"));
  CHECK_THAT(refusal({"a.obj", "-n", "3", "--chord-tolerance", "1e-11"}),
             Contains("'1e-11' is not a finite number from 1e-10 on"));
}

TEST_CASE("an option that does nothing is refused") {
  const std::vector<std::vector<std::string>> wrong{
      {"--vertices", "3", "--seed", "1"},
      {"--generators", "g.txt", "--seed", "1"},
      {"--radius", "1", "--sampling", "random"},
      {"-n", "3", "--merge-coincident"},
      {"--vertices", "3", "--max-snap", "1"},
      {"-n", "3", "-o", "a.ply", "--output-format", "obj"},
      {"-n", "3", "-q", "-v"},
  };
  for (std::vector<std::string> arguments : wrong) {
    arguments.insert(arguments.begin(), "a.obj");
    CHECK_THAT(refusal(arguments), Contains("has no effect here: add") || Contains(" exclude each other: keep one") ||
                                       Contains(" needs ") || Contains("a radius gives farthest or poisson points"));
  }
  CHECK_NOTHROW(parse_options({"a.obj", "-n", "3", "-o", "a.ply", "-o", "-", "--output-format", "obj"}));
  CHECK_NOTHROW(parse_options({"a.obj", "--radius", "3", "--seed", "1"}));
}

TEST_CASE("every target has a known extension, a folder, and a name of its own") {
  const test::ScratchFolder scratch;
  const auto with = [&](std::vector<std::string> outputs) {
    outputs.insert(outputs.begin(), {"a.obj", "-n", "3"});
    return outputs;
  };
  CHECK_THAT(refusal(with({"-o", "a.doc"})), Contains("a.doc") && Contains(".ply, .obj or .json"));
  CHECK_THAT(refusal(with({"-o", ""})), Contains("empty"));
  CHECK_THAT(refusal(with({"-o", "a.ply", "-o", "./a.ply"})), Contains("-o ./a.ply: two outputs go there"));
  CHECK_THAT(refusal(with({"-o", "-", "-o", "-"})), Contains("two outputs go there"));
  CHECK_THAT(refusal(with({"-o", "a.json", "--report", "a.json"})), Contains("--report a.json: two outputs"));
  CHECK_THAT(refusal(with({"--report", "-"})), Contains("only -o can write to standard output"));
  CHECK_THAT(refusal(with({"--report", scratch / ""}), ErrorCode::unwritable_output), Contains("is a directory"));
  CHECK_THAT(refusal(with({"-o", scratch / "none/a.ply"}), ErrorCode::unwritable_output),
             Contains("there is no directory"));
  CHECK_NOTHROW(check_line(with({"-o", scratch / "a.ply", "-o", "-", "--report", scratch / "r.json"})));
}

TEST_CASE("an option of a format that is not written is refused") {
  CHECK_THAT(refusal({"a.obj", "-n", "3", "-o", "b.ply", "--no-curves"}), Contains("only .obj, .vtp, .vtu and .glb"));
  CHECK_THAT(refusal({"a.obj", "-n", "3", "-o", "b.obj", "--ascii-ply"}), Contains("no .ply is written"));
  CHECK_NOTHROW(check_line({"a.obj", "-n", "3", "-o", "b.obj", "-o", "-", "--no-curves", "--ascii-ply"}));
}

TEST_CASE("an option of a format in a file goes where the command line writes another format") {
  const test::ScratchFolder scratch;
  const std::string config = scratch / "o.toml";
  test::write_text(config, "output = \"" + scratch / "b.obj" + "\"\nno-curves = true\nn = 3\n");
  CHECK(parse_options({"a.obj", "--config", config}).output.no_curves);
  const Options other = parse_options({"a.obj", "-o", "b.ply", "--config", config});
  CHECK(!other.output.no_curves);
  CHECK(other.output.files == std::vector<std::string>{"b.ply"});
  CHECK_THAT(refusal({"a.obj", "-o", "b.ply", "--no-curves", "--config", config}), Contains("only .obj, .vtp"));
  test::write_text(config, "output = \"b.ply\"\nno-curves = true\n");
  CHECK_THAT(refusal({"a.obj", "--config", config}), Contains("o.toml:2:1: no-curves: only .obj, .vtp"));
  test::write_text(config, "ascii-ply = true\n");
  CHECK(!parse_options({"a.obj", "-o", "b.obj", "--config", config}).output.ascii_ply);
}

TEST_CASE("no target is a file that the run reads, whatever it is called") {
  const test::ScratchFolder scratch;
  const std::string mesh = scratch / "mesh.obj", list = scratch / "list.json";
  test::write_text(mesh, "v 0 0 0\n");
  test::write_text(list, "{}");
  std::filesystem::create_hard_link(mesh, scratch / "hard.obj");
  for (const char* name : {"mesh.obj", "hard.obj", "./mesh.obj"}) {
    CHECK_THAT(refusal({mesh, "-n", "3", "-o", scratch / name}), Contains("the run reads this file"));
  }
  CHECK_THAT(refusal({mesh, "--generators", list, "--report", list}), Contains("the run reads this file"));
}

TEST_CASE("an output's place is compared with every file that the command's own options read") {
  const test::ScratchFolder scratch;
  const std::string mesh = scratch / "mesh.obj", numbers = scratch / "numbers.json";
  test::write_text(mesh, "v 0 0 0\n");
  test::write_text(numbers, "1\n");
  const auto refused = [&](const std::string& option, const std::string& value) {
    test::SharedLine line;
    std::string file;
    GivenNumbers source;
    GivenCurves curves;
    GivenPoints points;
    line.list.option("fixed", File{&file}, {.help = "A file"});
    line.list.option("within", ValueSource{&source}, {.help = "A file or a property"});
    line.list.option("curves", Curves{&curves, 30}, {.help = "A file or a kind of curves"});
    line.list.option("to", PointList{&points}, {.help = "A file or vertices"});
    return test::refusal(
        [&] {
          check_line(line, {mesh, "-n", "3", "--report", numbers, option, value});
        },
        ErrorCode::invalid_option);
  };
  for (const char* option : {"--fixed", "--within", "--curves", "--to"}) {
    CAPTURE(option);
    CHECK(refused(option, numbers) == "--report " + numbers + ": the run reads this file; name another one");
  }
  CHECK_NOTHROW(check_line({mesh, "-n", "3", "--report", numbers}));
}

TEST_CASE("for several inputs, no option reads a pipe") {
  const test::ScratchFolder scratch;
  const std::string a = scratch / "a.obj", b = scratch / "b.obj";
  for (const std::string& mesh : {a, b}) test::write_text(mesh, "v 0 0 0\n");
  REQUIRE(mkfifo((scratch / "pipe").c_str(), 0600) == 0);
  CHECK_THAT(refusal({a, b, "--output-dir", scratch / "out", "--generators", scratch / "pipe"}),
             Contains(scratch / "pipe" + ": a pipe can be read for one input only; name a file"));
  CHECK_NOTHROW(check_line({a, "--output-dir", scratch / "out", "--generators", scratch / "pipe"}));
}

TEST_CASE("a link that leads nowhere yet is the file that it names") {
  const test::ScratchFolder scratch;
  std::filesystem::create_symlink("b.ply", scratch / "a.ply");
  CHECK_THAT(refusal({"a.obj", "-n", "3", "-o", scratch / "a.ply", "-o", scratch / "b.ply"}),
             Contains("two outputs go there"));
}

TEST_CASE("the materials of an .obj are a file of the run, too") {
  const test::ScratchFolder scratch;
  test::write_text(scratch / "a.mtl", "v 0 0 0\n");
  CHECK_THAT(refusal({scratch / "a.mtl", "-n", "3", "-o", scratch / "a.obj"}), Contains("the run reads this file"));
  std::filesystem::create_directory(scratch / "b.mtl");
  CHECK_THAT(refusal({"a.obj", "-n", "3", "-o", scratch / "b.obj"}, ErrorCode::unwritable_output),
             Contains("is a directory"));
  CHECK_NOTHROW(check_line({"a.obj", "-n", "3", "-o", scratch / "c.obj"}));
  CHECK(!std::filesystem::exists(scratch / "c.mtl"));
  // Of a command that writes none, what lies there is nobody's business.
  CHECK_NOTHROW(check_line({"a.obj", "-n", "3", "-o", scratch / "b.obj"}, {test::kFormats, false}));
}

TEST_CASE("the file of options is not replaced") {
  const test::ScratchFolder scratch;
  test::write_text(scratch / "o.json", "n = 3\n");
  CHECK_THAT(refusal({"a.obj", "--config", scratch / "o.json", "--report", scratch / "o.json"}),
             Contains("the run reads this file"));
}

TEST_CASE("a folder of outputs that is none, or can't be made, is refused with what to do") {
  const test::ScratchFolder scratch;
  const std::string mesh = scratch / "a.obj";
  test::write_text(mesh, "v 0 0 0\n");
  const auto into = [&](const std::string& folder) {
    return refusal({mesh, "-n", "3", "--output-dir", folder}, ErrorCode::unwritable_output);
  };
  CHECK(into(mesh) == "--output-dir " + mesh + ": is a file; name a folder");
  for (const char* nested : {"x/y", "x/y/", "x/y//"}) {
    CHECK_THAT(into(scratch / nested), Contains(": there is no directory " + scratch / "x; create it first"));
  }
  CHECK_THAT(into(mesh + "/x"), Contains(": " + mesh + " is not a directory; choose another one"));
  CHECK_THAT(refusal({mesh, "-n", "3", "-o", mesh + "/b.ply"}, ErrorCode::unwritable_output),
             Contains(": " + mesh + " is not a directory; choose another one"));
  CHECK(refusal({mesh, "-n", "3", "--output-dir", ""}) ==
        "--output-dir: the name is empty; name a folder (see gvd-test --help)");
  CHECK_NOTHROW(check_line({mesh, "-n", "3", "--output-dir", scratch / "new/"}));
  CHECK(std::filesystem::is_directory(scratch / "new"));
}

TEST_CASE("what is named twice is told as such") {
  const test::ScratchFolder scratch;
  const std::string mesh = scratch / "a.obj", out = scratch / "out";
  test::write_text(mesh, "v 0 0 0\n");
  CHECK_THAT(refusal({mesh, "-n", "3", "--output-dir", out, "--output-format", "ply,obj,ply"}),
             Contains("--output-format: ply is given twice; keep one"));
  CHECK(refusal({mesh, scratch / "./a.obj", "-n", "3", "--output-dir", out}) ==
        "INPUT " + scratch / "./a.obj: given twice; keep one");
}

TEST_CASE("an option of a format that is not written names the option that chooses it") {
  const auto with = [](std::vector<std::string> outputs) {
    outputs.insert(outputs.begin(), {"a.obj", "-n", "3"});
    return refusal(outputs);
  };
  CHECK_THAT(with({"--output-dir", "out", "--no-curves"}), Contains("write one of them with --output-format or"));
  CHECK_THAT(with({"-o", "-", "--output-format", "obj", "--ascii-ply"}), Contains("write one with --output-format or"));
  CHECK_THAT(with({"-o", "a.obj", "--ascii-ply"}), Contains("write one with -o or"));
}

TEST_CASE("each input has a run, with files of its name in the folder") {
  Options options;
  options.input.paths = {"a/x.ply", "y.z.obj", "scan.stl.GZ"};
  options.input.path = "a/x.ply";
  options.output.folder = "out";
  options.output.formats = {"ply", "json"};
  const std::vector<Options> runs = plan_runs(options);
  REQUIRE(runs.size() == 3);
  CHECK(runs[2].output.files == std::vector<std::string>{"out/scan.ply", "out/scan.json"});
  CHECK(runs[0].input.path == "a/x.ply");
  CHECK(runs[0].output.files == std::vector<std::string>{"out/x.ply", "out/x.json"});
  CHECK(runs[1].input.path == "y.z.obj");
  CHECK(runs[1].output.files == std::vector<std::string>{"out/y.z.ply", "out/y.z.json"});
}

TEST_CASE("without a folder the outputs are those of the command line") {
  Options options;
  options.input.paths = {"x.ply"};
  options.output.files = {"a.obj"};
  CHECK(plan_runs(options).front().output.files == std::vector<std::string>{"a.obj"});
}

}  // namespace gvd::test_check_options
