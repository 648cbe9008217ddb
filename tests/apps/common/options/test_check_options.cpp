#include <filesystem>

#include "apps/common/options/parse_options.hpp"
#include "apps/run_command.hpp"
#include "common/options/check_options.hpp"
#include "gvd/error.hpp"
#include "support/catch.hpp"

using namespace gvd;
using namespace gvd::app;
using Catch::Matchers::Contains;
using gvd::test::kFormats;
using gvd::test::parse_options;

namespace {

/// The message of a refusal, which is one line.
std::string refusal(const std::vector<std::string>& arguments, ErrorCode code = ErrorCode::invalid_option) {
  CAPTURE(arguments);
  try {
    check_options(parse_options(arguments), kFormats);
  } catch (const Error& error) {
    CHECK(error.code() == code);
    CHECK(std::string(error.what()).find('\n') == std::string::npos);
    return error.what();
  }
  return "nothing was refused";
}

}  // namespace

TEST_CASE("generators come from exactly one option") {
  CHECK_NOTHROW(check_options(parse_options({"a.obj", "--vertices", "1,2"}), kFormats));
  CHECK(refusal({"a.obj"}) == "no generators: give one of -n, --generators, --vertices or --radius");
  CHECK_THAT(refusal({"a.obj", "-n", "3", "--radius", "1"}), Contains("-n and --radius"));
  CHECK_THAT(refusal({"a.obj", "--vertices", "1", "--generators", "g.txt"}), Contains("--generators and --vertices"));
}

TEST_CASE("standard input needs a format") {
  CHECK_THAT(refusal({"-", "-n", "3"}), Contains("--input-format"));
  CHECK_NOTHROW(check_options(parse_options({"-", "-n", "3", "--input-format", "off"}), kFormats));
}

TEST_CASE("an option that the method ignores is refused, with what to do") {
  CHECK_THAT(refusal({"a.obj", "-n", "3", "--front", "planar"}), Contains("add --method gbgvd"));
  CHECK_THAT(refusal({"a.obj", "-n", "3", "--method", "gbgvd", "--chord-tolerance", "1e-3"}),
             Contains("--method gbgvd and --chord-tolerance exclude each other"));
  CHECK_THAT(refusal({"a.obj", "-n", "3", "--chord-tolerance", "1e-11"}), Contains("1e-11") && Contains("1e-10"));
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
    CHECK_THAT(refusal(arguments), Contains("does nothing here: add") || Contains("exclude each other"));
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
  CHECK_THAT(refusal(with({"-o", "a.doc"})), Contains("a.doc") && Contains(".ply, .obj, .json"));
  CHECK_THAT(refusal(with({"-o", ""})), Contains("empty"));
  CHECK_THAT(refusal(with({"-o", "a.ply", "-o", "./a.ply"})), Contains("-o ./a.ply: two options name this file"));
  CHECK_THAT(refusal(with({"-o", "-", "-o", "-"})), Contains("two options name this file"));
  CHECK_THAT(refusal(with({"-o", "a.json", "--report", "a.json"})), Contains("--report a.json: two options"));
  CHECK_THAT(refusal(with({"--report", "-"})), Contains("only -o can write to standard output"));
  CHECK_THAT(refusal(with({"--report", scratch / ""}), ErrorCode::unwritable_output), Contains("is a directory"));
  CHECK_THAT(refusal(with({"-o", scratch / "none/a.ply"}), ErrorCode::unwritable_output),
             Contains("there is no directory"));
  CHECK_NOTHROW(check_options(parse_options(with({"-o", scratch / "a.ply", "-o", "-", "--report", scratch / "r.json"})),
                              kFormats));
}

TEST_CASE("an option of a format that is not written is refused") {
  CHECK_THAT(refusal({"a.obj", "-n", "3", "-o", "b.ply", "--no-curves"}), Contains("only .obj, .vtp and .glb"));
  CHECK_THAT(refusal({"a.obj", "-n", "3", "-o", "b.obj", "--ascii-ply"}), Contains("no .ply is written"));
  CHECK_NOTHROW(check_options(
      parse_options({"a.obj", "-n", "3", "-o", "b.obj", "-o", "-", "--no-curves", "--ascii-ply"}), kFormats));
}

TEST_CASE("no target is a file that the run reads, whatever it is called") {
  const test::ScratchFolder scratch;
  const std::string mesh = scratch / "mesh.obj", list = scratch / "list.json";
  test::write_text(mesh, "v 0 0 0\n");
  test::write_text(list, "{}");
  std::filesystem::create_hard_link(mesh, scratch / "hard.obj");
  for (const char* name : {"mesh.obj", "hard.obj", "./mesh.obj"}) {
    CHECK_THAT(refusal({mesh, "-n", "3", "-o", scratch / name}), Contains("this is the file that is read"));
  }
  CHECK_THAT(refusal({mesh, "--generators", list, "--report", list}), Contains("this is the file that is read"));
}
