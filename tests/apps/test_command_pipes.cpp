// Files that are pipes, as bash's <(program) gives them: INPUT and what options read.

#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "apps/require_error.hpp"
#include "apps/run_command.hpp"
#include "support/catch.hpp"

namespace gvd::test_command_pipes {

using namespace test;
using Catch::Matchers::Contains;

/// A square of four triangles round a vertex in the middle, each corner with a colour and a part.
const char* const kSquare =
    "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
    "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty int part\n"
    "element face 4\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0 255 0 0 1\n2 0 0 255 0 0 1\n2 2 0 255 0 0 2\n0 2 0 255 0 0 2\n1 1 0 255 0 0 1\n"
    "3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n";

/// A folder with the square, numbers for its faces, and a pipe.
class Pipes {
 public:
  Pipes() {
    write_text(mesh, kSquare);
    write_text(numbers, "1 1 2 2\n");
    write_text(mask, "0 0 0 1\n");
    REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  }

  /// Runs a command while another program writes `content` into the pipe.
  CommandResult run(const std::string& name, const std::string& arguments, const std::string& content) const {
    return run_command(name, arguments + " & run=$!\ncat " + content + " > " + pipe + "\nwait $run");
  }

  ScratchFolder scratch;
  std::string mesh = scratch / "square.ply", numbers = scratch / "numbers.txt", mask = scratch / "mask.txt",
              pipe = scratch / "pipe";
};

TEST_CASE("commands: what an option reads may be a pipe, and gives the result of the file") {
  const Pipes at;
  const std::vector<std::string> built = built_commands();
  for (const auto& [name, option, file] :
       std::vector<std::array<std::string, 3>>{{"gvd-segment", "--within ", at.numbers},
                                               {"gvd-segment", "--mask ", at.mask},
                                               {"gvd-segment", "--balance ", at.numbers},
                                               {"gvd-lloyd", "--density ", at.numbers}}) {
    if (std::ranges::find(built, name) == built.end()) continue;
    CAPTURE(name, option);
    const std::string rest = " -n 2 " + at.mesh + " -q -o ";
    const CommandResult named = run_command(name, option + file + rest + at.scratch / "named.ply");
    const CommandResult piped = at.run(name, option + at.pipe + rest + at.scratch / "piped.ply", file);
    CAPTURE(named.err, piped.err);
    REQUIRE(named.exit_code == 0);
    REQUIRE(piped.exit_code == 0);
    CHECK(read_text(at.scratch / "named.ply") == read_text(at.scratch / "piped.ply"));
  }
  const CommandResult wrong = at.run("gvd-segment", "--within " + at.pipe + " -n 2 " + at.mesh, at.mesh);
  CHECK(wrong.exit_code == 3);
  CHECK_THAT(wrong.err, Contains(at.pipe + ":1: 'ply' is not a number"));
}

TEST_CASE("gvd-segment: --weights and --shares read standard input, which can't be the mesh, too") {
  const Pipes at;
  write_text(at.numbers, "0 0.25\n");
  const std::string run = at.mesh + " -q --vertices 0,2 -o ";
  for (const std::string option : {"--weights ", "--balance area --shares "}) {
    CAPTURE(option);
    if (option != "--weights ") write_text(at.numbers, "1 3\n");
    const CommandResult named = run_command("gvd-segment", option + at.numbers + " " + run + at.scratch / "named.ply");
    const CommandResult piped =
        run_command("gvd-segment", option + "- " + run + at.scratch / "piped.ply < " + at.numbers);
    CAPTURE(named.err, piped.err);
    REQUIRE(named.exit_code == 0);
    REQUIRE(piped.exit_code == 0);
    CHECK(read_text(at.scratch / "named.ply") == read_text(at.scratch / "piped.ply"));
  }
  write_text(at.numbers, "1 2 3\n");
  require_error("gvd-segment", run + "a.ply --weights - < " + at.numbers, 3,
                "standard input: 3 numbers for 2 generators; --weights takes one for each");
  require_error("gvd-segment", "- --input-format ply -n 2 --weights - < " + at.mesh, 2,
                "INPUT and --weights are both standard input, which holds one of them: name a file for the other");
  require_error("gvd-segment", at.mesh + " --generators - --balance area --shares - < " + at.numbers, 2,
                "--generators and --shares are both standard input");
}

TEST_CASE("commands: a .gltf from a pipe lacks its buffers, and the message says to name the file") {
  const Pipes at;
  const std::string mesh = at.scratch / "mesh.gltf";
  write_text(mesh, R"({"asset":{"version":"2.0"},"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
                   R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],)"
                   R"("bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":"a.bin"}]})");
  write_text(at.scratch / "a.bin", std::string(36, '\0'));
  const std::string advice =
      "buffer 0, 'a.bin', is not in the file; name the mesh by its path, with the buffer beside it, or export one "
      ".glb\n";
  const CommandResult result = at.run("gvd-segment", at.pipe + " -n 1", mesh);
  CHECK(result.exit_code == 3);
  CHECK(result.err == "gvd-segment: error: " + at.pipe + ": " + advice);
  CHECK(run_command("gvd-segment", "- --input-format gltf -n 1 < " + mesh).err ==
        "gvd-segment: error: standard input: " + advice);
}

TEST_CASE("commands: of a piped INPUT properties are not read by name, and the message says so") {
  const Pipes at;
  const CommandResult result = at.run("gvd-segment", at.pipe + " -n 2 --within part", at.mesh);
  CHECK(result.exit_code == 3);
  CHECK(result.err ==
        "gvd-segment: error: --within part: there is no such file, and properties are read from files "
        "only: save " +
            at.pipe + " as one\n");
  require_error("gvd-segment", "- --input-format ply -n 2 --within part < " + at.mesh, 3,
                "properties are read from files only: save standard input as one");
  require_error("gvd-segment", at.mesh + " -n 2 --within - < " + at.numbers, 3,
                "--within -: takes a file or a property; for standard input, give /dev/stdin");
  require_error("gvd-segment", at.mesh + " -n 2 --mask " + at.scratch / "", 3, ": is a directory; give a file");
  CHECK(run_command("gvd-segment", at.mesh + " -n 2 -q --within /dev/stdin < " + at.numbers).exit_code == 0);
}

TEST_CASE("gvd-remesh: --carry takes the properties of a piped INPUT from what was read") {
  const std::vector<std::string> built = built_commands();
  if (std::ranges::find(built, "gvd-remesh") == built.end()) return;
  const Pipes at;
  const std::string options = " -n 30 -q --carry -o ", painted = at.scratch / "painted.ply";
  const std::string named = at.scratch / "named.ply", piped = at.scratch / "piped.ply";
  // Vertices and faces with the colours of regions.
  REQUIRE(run_command("gvd-segment", data_file("torus.ply") + " -n 3 -q -o " + painted).exit_code == 0);
  REQUIRE(run_command("gvd-remesh", painted + options + named).exit_code == 0);
  const CommandResult result = at.run("gvd-remesh", at.pipe + options + piped, painted);
  CAPTURE(result.err);
  REQUIRE(result.exit_code == 0);
  CHECK_THAT(read_text(named), Contains("property uchar red"));
  CHECK(read_text(named) == read_text(piped));
  const CommandResult unknown = at.run("gvd-remesh", at.pipe + options + piped, at.numbers);
  CHECK(unknown.exit_code == 3);
  CHECK_THAT(unknown.err,
             Contains(at.pipe + ": the content does not tell the format; name the format with --input-format"));
}

}  // namespace gvd::test_command_pipes
