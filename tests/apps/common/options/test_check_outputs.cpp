#include <filesystem>

#include "apps/common/options/parse_options.hpp"
#include "apps/run_command.hpp"
#include "common/options/check_outputs.hpp"
#include "support/catch.hpp"
#include "support/refusal.hpp"

namespace gvd::test_check_outputs {

using namespace app;
using Catch::Matchers::Contains;
using gvd::test::kOutputFormats;
using gvd::test::parse_options;

std::string refusal(const std::vector<std::string>& arguments, ErrorCode code = ErrorCode::invalid_option) {
  CAPTURE(arguments);
  return test::refusal([&] { check_outputs(parse_options(arguments), kOutputFormats); }, code);
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
  CHECK_NOTHROW(check_outputs(parse_options(with({"-o", scratch / "a.ply", "-o", "-", "--report", scratch / "r.json"})),
                              kOutputFormats));
}

TEST_CASE("an option of a format that is not written is refused") {
  CHECK_THAT(refusal({"a.obj", "-n", "3", "-o", "b.ply", "--no-curves"}), Contains("only .obj, .vtp and .glb"));
  CHECK_THAT(refusal({"a.obj", "-n", "3", "-o", "b.obj", "--ascii-ply"}), Contains("no .ply is written"));
  CHECK_NOTHROW(check_outputs(
      parse_options({"a.obj", "-n", "3", "-o", "b.obj", "-o", "-", "--no-curves", "--ascii-ply"}), kOutputFormats));
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
    CHECK_THAT(refusal({mesh, "-n", "3", "-o", scratch / name}), Contains("this is the file that is read"));
  }
  CHECK_THAT(refusal({mesh, "--generators", list, "--report", list}), Contains("this is the file that is read"));
}

TEST_CASE("a link that leads nowhere yet is the file that it names") {
  const test::ScratchFolder scratch;
  std::filesystem::create_symlink("b.ply", scratch / "a.ply");
  CHECK_THAT(refusal({"a.obj", "-o", scratch / "a.ply", "-o", scratch / "b.ply"}),
             Contains("two options name this file"));
}

TEST_CASE("the materials of an .obj are a file of the run, too") {
  const test::ScratchFolder scratch;
  CHECK_THAT(refusal({"a.obj", "-o", scratch / "a.obj", "--report", scratch / "a.mtl"}),
             Contains("two options name this file"));
  std::filesystem::create_directory(scratch / "b.mtl");
  CHECK_THAT(refusal({"a.obj", "-o", scratch / "b.obj"}, ErrorCode::unwritable_output), Contains("is a directory"));
  CHECK_NOTHROW(check_outputs(parse_options({"a.obj", "-o", scratch / "c.obj"}), kOutputFormats));
  CHECK(!std::filesystem::exists(scratch / "c.mtl"));
  // Of a command that writes none, what lies there is nobody's business.
  CHECK_NOTHROW(check_outputs(parse_options({"a.obj", "-o", scratch / "b.obj"}), {test::kFormats, false}));
}

TEST_CASE("the file of options is not replaced") {
  const test::ScratchFolder scratch;
  test::write_text(scratch / "o.toml", "n = 3\n");
  CHECK_THAT(refusal({"a.obj", "--config", scratch / "o.toml", "--report", scratch / "o.toml"}),
             Contains("this is the file that is read"));
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
  CHECK(refusal({mesh, "-n", "3", "--output-dir", ""}) ==
        "--output-dir: the name is empty; name a folder (see gvd-test --help)");
  CHECK_NOTHROW(check_outputs(parse_options({mesh, "-n", "3", "--output-dir", scratch / "new/"}), kOutputFormats));
  CHECK(std::filesystem::is_directory(scratch / "new"));
}

TEST_CASE("what is named twice is told as such") {
  const test::ScratchFolder scratch;
  const std::string mesh = scratch / "a.obj", out = scratch / "out";
  test::write_text(mesh, "v 0 0 0\n");
  CHECK_THAT(refusal({mesh, "-n", "3", "--output-dir", out, "--output-format", "ply,obj,ply"}),
             Contains("--output-format: ply is there twice; keep one"));
  CHECK(refusal({mesh, scratch / "./a.obj", "-n", "3", "--output-dir", out}) ==
        "INPUT " + scratch / "./a.obj: is there twice; keep one");
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

}  // namespace gvd::test_check_outputs
