// What the commands write: whether they can, which files they must not replace, and the same bytes every time.

#include <filesystem>
#include <regex>

#include "apps/require_error.hpp"
#include "apps/run_command.hpp"
#include "support/catch.hpp"

namespace gvd::test_command_outputs {

using namespace test;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

TEST_CASE("commands: what can't be written exits with 6") {
  const std::string mesh = data_file("torus.ply") + " -n 20 ";
  for (const std::string& name : built_commands()) {
    require_error(name, mesh + "--report /dev/full -q", 6, "/dev/full");
    require_error(name, mesh + "--diagram /dev/full -q", 6, "/dev/full");
    require_error(name, mesh + "-o /nonexistent/a.json", 6, "/nonexistent");
    require_error(name, mesh + "-o - -q > /dev/full", 6, "standard output");
    require_error(name, mesh + "-o - -q >&-", 6, "standard output");
    CHECK(std::filesystem::is_character_file("/dev/full"));
  }
}

TEST_CASE("commands: whether outputs can be written is found out before the work") {
  namespace fs = std::filesystem;
  const ScratchFolder scratch;
  fs::create_directory(scratch / "folder.ply");
  fs::create_directory(scratch / "c.mtl");
  write_text(scratch / "options.toml", "quiet = true\n");
  const std::string missing = scratch / "missing.obj", start = missing + " -n 20 --config " + scratch / "options.toml ";
  // The input is missing, which is said once it is read: what is said of an output is said before.
  for (const std::string& name : built_commands()) {
    require_error(name, start + "-o /proc/x.ply", 6,
                  "'/proc/x.ply': no file can be made in its folder; choose another folder");
    require_error(name, start + "-o " + scratch / "folder.ply", 6, "is a directory");
    require_error(name, start + "-o " + scratch / "none/a.ply", 6, "create it first");
    // gvd-remesh has no regions to colour: it writes no .mtl.
    require_error(name, start + "-o " + scratch / "c.obj", name == "gvd-remesh" ? 3 : 6,
                  name == "gvd-remesh" ? missing : "c.mtl: is a directory");
    require_error(name, start + "-o a.json --diagram ./a.json", 2, "two outputs go there");
    require_error(name, start + "-o - >&-", 6, "standard output is closed");
    for (const char* option : {"--report ", "--diagram ", "--view "}) {
      require_error(name, start + option + "''", 2, "the name is empty");
      require_error(name, start + option + "/proc/x", 6, "/proc/x");
    }
    require_error(name, start + "-o " + scratch / "a.ply", 3, missing);
  }
  fs::remove_all(scratch / "folder.ply");
  fs::remove_all(scratch / "c.mtl");
  fs::remove(scratch / "options.toml");
  CHECK(fs::is_empty(scratch / ""));
}

/// The options of a command that name a file to write beside those of -o, with their types, as --help lists them.
std::vector<std::pair<std::string, std::string>> side_outputs(const std::string& name) {
  const std::string help = run_command(name, "--help").out;
  const std::size_t begin = help.find("\nOutput:\n");
  const std::string group = help.substr(begin, help.find("\n\n", begin) - begin);
  const std::regex line("(--[a-z-]+) (FILE\\S*)");
  std::vector<std::pair<std::string, std::string>> found;
  for (std::sregex_iterator match(group.begin(), group.end(), line), last; match != last; ++match) {
    if ((*match)[1] != "--output") found.emplace_back((*match)[1], (*match)[2]);
  }
  return found;
}

TEST_CASE("commands: no side output replaces a file of another kind") {
  const ScratchFolder scratch;
  write_text(scratch / "keep.stl", "a mesh");
  std::vector<std::string> commands = built_commands();
  commands.emplace_back("gvd-distance");
  for (const std::string& name : commands) {
    const std::string start = data_file("torus.ply") + (name == "gvd-distance" ? " --from 3 " : " -n 5 ");
    const auto outputs = side_outputs(name);
    CHECK(outputs.size() >= 3);
    for (const auto& [option, type] : outputs) {
      CAPTURE(name, option);
      CHECK_THAT(type, StartsWith("FILE."));  // it tells what is accepted
      const std::string folder = option == "--summary" ? " --output-dir " + scratch / "" : "";
      for (const char* file : {"keep.stl", "none", "a.json.stl"}) {
        const std::string path = scratch / file;
        require_error(name, start + option + " " + path + folder, 2,
                      option + ": '" + path + "': the extension must be ");
      }
    }
  }
  CHECK(read_text(scratch / "keep.stl") == "a mesh");
}

TEST_CASE("commands: a file that grows too large is one line, and leaves nothing") {
  const ScratchFolder scratch;
  write_text(scratch / "a.ply", "old");
  for (const std::string& name : built_commands()) {
    // Long enough for any of the three: 1 is 512 bytes.
    const std::string run = "ulimit -f 1; exec '" + std::string(GVD_BIN_DIR) + "/" + name + "' " +
                            data_file("torus.ply") + " -n 40 -q -o " + scratch / "a.ply";
    const CommandResult result = run_command("/bin/sh", "-c \"" + run + "\"");
    CAPTURE(name, result.err);
    CHECK(result.exit_code == 6);
    CHECK(line_count(result.err) == 1);
    CHECK_THAT(result.err, StartsWith(name + ": error: cannot write ") && Contains("a.ply"));
    CHECK(read_text(scratch / "a.ply") == "old");
  }
  CHECK(std::distance(std::filesystem::directory_iterator(scratch / ""), {}) == 1);
}

TEST_CASE("commands: a mesh that the format can't hold is refused before the work") {
  const ScratchFolder scratch;
  write_text(scratch / "vast.off", "OFF 3 1 0\n0 0 0\n1e39 0 0\n0 1e39 0\n3 0 1 2\n");
  for (const std::string& name : built_commands()) {
    for (const char* format : {"stl", "glb"}) {
      // A verbose run names each step: there are only those of reading.
      const std::string arguments = scratch / "vast.off" + " -n 3 -v -o " + scratch / "a." + format;
      const CommandResult result = run_command(name, arguments);
      CHECK(result.exit_code == 6);
      CHECK_THAT(result.err, Contains("32-bit floats") && !Contains("generators"));
      CHECK(!std::filesystem::exists(scratch / "a." + format));
    }
  }
  CHECK(run_command("gvd-segment", scratch / "vast.off" + " -n 3 -q -o " + scratch / "a.ply").exit_code == 0);
}

TEST_CASE("commands: no output replaces a file that is read") {
  namespace fs = std::filesystem;
  const ScratchFolder scratch;
  const std::string mesh = scratch / "mesh.ply", list = scratch / "list.json";
  fs::copy_file(data_file("torus.ply"), mesh);
  write_text(list, "1\n5\n");
  fs::create_symlink(mesh, scratch / "link.ply");
  for (const char* name : {"hard.ply", "hard.json", "hard.html"}) fs::create_hard_link(mesh, scratch / name);
  fs::create_directory(scratch / "folder");
  const std::string before = read_text(mesh), what = "the run reads this file";
  for (const std::string& name : built_commands()) {
    for (const char* spelling : {"mesh.ply", "./mesh.ply", "folder/../mesh.ply", "link.ply", "hard.ply"}) {
      const std::string path = scratch / spelling;
      require_error(name, mesh + " -n 20 -o " + path, 2, path + ": " + what);
      require_error(name, path + " -n 20 -o " + mesh, 2, mesh + ": " + what);
      require_error(name, "- --input-format ply -n 20 -o " + path + " < " + mesh, 2, path + ": " + what);
    }
    for (const char* option : {"--report ", "--diagram ", "--view "}) {
      const std::string path = scratch / (option == std::string("--view ") ? "hard.html" : "hard.json");
      require_error(name, mesh + " -n 20 " + option + path, 2, path + ": " + what);
    }
    require_error(name, mesh + " --generators-format text --generators " + list + " --report " + list, 2,
                  list + ": " + what);
  }
  CHECK(read_text(mesh) == before);
  CHECK(read_text(list) == "1\n5\n");
}

TEST_CASE("commands: the same call gives the same bytes") {
  const ScratchFolder scratch;
  for (const std::string& name : built_commands()) {
    std::string arguments = data_file("torus.ply") + " -q -n 40 --seed 3";
    std::string again = arguments + " --threads 1";
    const std::vector<std::string> files{"a.ply", "a.obj", "a.off", "a.stl", "a.vtp", "a.vtu", "a.glb", "a.json"};
    std::filesystem::create_directory(scratch / "first" + name);
    std::filesystem::create_directory(scratch / "again" + name);
    for (const std::string& file : files) {
      arguments += " -o " + scratch / "first" + name + "/" + file;
      again += " -o " + scratch / "again" + name + "/" + file;
    }
    REQUIRE(run_command(name, arguments + " --diagram " + scratch / "first" + name + "/d.json").exit_code == 0);
    REQUIRE(run_command(name, again + " --diagram " + scratch / "again" + name + "/d.json").exit_code == 0);
    for (const auto& entry : std::filesystem::directory_iterator(scratch / "first" + name)) {
      const std::string file = entry.path().filename().string();
      CAPTURE(name, file);
      CHECK(std::filesystem::file_size(entry.path()) > 100);
      CHECK(read_text(entry.path().string()) == read_text(scratch / "again" + name + "/" + file));
    }
  }
}

}  // namespace gvd::test_command_outputs
