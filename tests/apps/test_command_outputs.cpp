// What the commands write: whether they can, which files they must not replace, and the same bytes every time.

#include <chrono>
#include <filesystem>
#include <regex>
#include <thread>

#include "apps/require_error.hpp"
#include "apps/run_command.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"

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

TEST_CASE("commands: no output replaces a file that INPUT refers to, or that an option reads") {
  namespace fs = std::filesystem;
  const ScratchFolder scratch;
  fs::create_directory(scratch / "numbers");
  // (0, 0, 0), (1, 0, 0), (0, 1, 0) as floats.
  std::string numbers(36, '\0');
  for (const std::size_t at : {12, 28}) numbers.replace(at + 2, 2, "\x80\x3f");
  const auto scene = [&](const std::string& buffer) {
    write_text(scratch / buffer, numbers);
    write_text(scratch / "scene.gltf",
               R"({"asset":{"version":"2.0"},"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
               R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],)"
               R"("bufferViews":[{"buffer":0,"byteLength":36}],"images":[{"uri":"image.html"}],)"
               R"("buffers":[{"byteLength":36,"uri":")" +
                   buffer + R"("}]})");
    return scratch / "scene.gltf";
  };
  // A buffer, and an output that would replace it.
  for (const auto& [buffer, options] : std::vector<std::pair<std::string, std::string>>{
           {"buffer.bin", "--output-format fs -o " + scratch / "buffer.bin"},
           {"numbers/a.ply", "-o " + scratch / "numbers/a.ply"},
           {"a.json", "--report " + scratch / "numbers/../a.json"},
           {"b.mtl", "-o " + scratch / "b.obj"},
           {"c.npy", "--face-labels " + scratch / "c.npy"}}) {
    CAPTURE(buffer);
    const std::string input = scene(buffer);
    require_error("gvd-segment", input + " -n 1 " + options, 2,
                  ": " + input + " refers to this file; name another one");
    CHECK(read_text(scratch / buffer) == numbers);
  }
  // An image, and a buffer by another name.
  write_text(scratch / "image.html", "an image");
  require_error("gvd-segment", scene("buffer.bin") + " -n 1 --view " + scratch / "image.html", 2,
                "refers to this file");
  fs::create_hard_link(scratch / "buffer.bin", scratch / "hard.json");
  require_error("gvd-segment", scene("buffer.bin") + " -n 1 --report " + scratch / "hard.json", 2,
                "refers to this file");
  CHECK(run_command("gvd-segment", scene("buffer.bin") + " -n 1 -q -o " + scratch / "scene.ply").exit_code == 0);

  const std::string painted = scratch / "painted.obj";
  write_text(painted, "mtllib paint.mtl\nusemtl red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  require_error("gvd-segment", painted + " -n 1 --output-format fs -o " + scratch / "paint.mtl", 2,
                "paint.mtl: " + painted + " refers to this file; name another one");
  CHECK(!fs::exists(scratch / "paint.mtl"));

  write_text(scratch / "labels.csv", "face,label\n0,5\n");
  require_error("gvd-segment",
                painted + " -n 1 --within " + scratch / "labels.csv --face-labels " + scratch / "labels.csv", 2,
                "labels.csv: the run reads this file");
  write_text(scratch / "o.toml", "within = \"" + scratch / "labels.csv" + "\"\n");
  require_error("gvd-segment", painted + " -n 1 --config " + scratch / "o.toml --stats " + scratch / "labels.csv", 2,
                "labels.csv: the run reads this file");
  CHECK(read_text(scratch / "labels.csv") == "face,label\n0,5\n");
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

TEST_CASE("commands: a run that succeeds names what it wrote in its last line, unless it is quiet") {
  const ScratchFolder scratch;
  const std::string torus = data_file("torus.ply"), ply = scratch / "a.ply", obj = scratch / "a.obj",
                    report = scratch / "r.json";
  const std::string given = torus + " -n 5 -o " + ply + " -o - --output-format off -o " + obj + " --report " + report;
  const CommandResult result = run_command("gvd-segment", given);
  REQUIRE(result.exit_code == 0);
  CHECK(result.err.ends_with("\ngvd-segment: wrote " + ply + ", " + obj + ", " + scratch / "a.mtl" + ", " + report +
                             "\n"));
  CHECK(run_command("gvd-segment", given + " -q").err.empty());
  for (const std::string& name : built_commands()) {
    const std::string file = scratch / (name == "gvd-lloyd" ? "b.txt" : "b.obj");
    CHECK_THAT(run_command(name, torus + " -n 40 -o " + file).err, Contains(name + ": wrote " + file));
    const std::string nothing = run_command(name, torus + " -n 40").err;
    CHECK_THAT(nothing, Contains("no file was written; name one") && !Contains("wrote "));
  }
  // An error is no success.
  CHECK_THAT(run_command("gvd-segment", torus + " -n 5 -o /dev/full -o " + ply).err, !Contains("wrote "));
  const CommandResult several =
      run_command("gvd-segment", torus + " " + data_file("figure.obj") + " -n 5 --output-dir " + scratch / "out" +
                                     " --output-format ply,json --view --summary " + scratch / "t.csv");
  CHECK_THAT(several.err, Contains("gvd-segment: wrote 6 files to " + scratch / "out" + ", " + scratch / "t.csv"));
}

/// A program that notes its arguments in the file `calls`, and then runs `rest`.
void write_program(const ScratchFolder& scratch, const std::string& name, const std::string& rest = "") {
  write_text(scratch / name, "#!/bin/sh\necho " + name + " \"$@\" > " + scratch / "calls" + "\n" + rest + "\n");
  std::filesystem::permissions(scratch / name, std::filesystem::perms::all);
}

/// Runs gvd-segment in the scratch folder, where PATH finds only what is there.
CommandResult run_for_page(const ScratchFolder& scratch, const std::string& environment, const std::string& options) {
  const std::string bin = std::filesystem::path(GVD_BIN_DIR).string();
  return run_command("gvd-segment", "--version > /dev/null; cd " + scratch / "." + " && PATH=" + scratch / "." + " " +
                                        environment + " '" + bin + "/gvd-segment' " + data_file("torus.ply") +
                                        " -n 5 --open " + options);
}

/// The call that a program of `write_program` noted, which may come a little after the end of the command.
std::string take_call(const ScratchFolder& scratch) {
  std::string call;
  for (int i = 0; i < 100 && !call.ends_with('\n'); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    call = read_text(scratch / "calls");
  }
  std::filesystem::remove(scratch / "calls");
  return call;
}

TEST_CASE("commands: --open shows the page, by $BROWSER or xdg-open, and never waits for it") {
  const ScratchFolder scratch;
  const std::string page = std::filesystem::path(scratch / "torus.gvd.html").string();
  const CommandResult none = run_for_page(scratch, "BROWSER=", "");
  CHECK(none.exit_code == 0);
  CHECK_THAT(
      none.err,
      Contains("wrote torus.gvd.html") &&
          Contains("--open: $BROWSER names no installed program, and xdg-open is not installed; open torus.gvd.html"));
  CHECK(std::filesystem::exists(page));
  write_program(scratch, "xdg-open");
  CHECK(run_for_page(scratch, "BROWSER=none", "-q").err.empty());
  CHECK(take_call(scratch) == "xdg-open " + page + "\n");
  run_for_page(scratch, "BROWSER=", "--view b.html");
  CHECK(take_call(scratch) == "xdg-open " + scratch / "b.html" + "\n");
  write_program(scratch, "fire", "/bin/sleep 30");
  const auto start = std::chrono::steady_clock::now();
  const CommandResult shown = run_for_page(scratch, "BROWSER='none:fire --new %s -x'", "");
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(15));
  CHECK(take_call(scratch) == "fire --new " + page + " -x\n");
  CHECK_THAT(shown.err, !Contains("--open"));
  write_program(scratch, "xdg-open", "exit 3");
  const CommandResult failed = run_for_page(scratch, "BROWSER=", "");
  CHECK(failed.exit_code == 0);
  CHECK_THAT(failed.err, Contains("xdg-open failed with exit code 3; open torus.gvd.html in a browser"));
  require_error("gvd-segment", data_file("torus.ply") + " -n 5 --open --output-dir " + scratch / "out", 2, "--open");
  require_error("gvd-segment", data_file("torus.ply") + " -n 5 --up z -o " + scratch / "a.ply", 2,
                "--up needs --view or --open: add one");
}

TEST_CASE("commands: many more generators than faces are told in advance, with time and memory") {
  if (kSanitized) return;  // a limit of memory would stop the sanitizer
  // The limit ends these runs, after the note.
  const auto notes = [&](const std::string& name, const std::string& count) {
    const CommandResult result = run_command(name, data_file("figure.obj") + " --max-memory 40M -n " + count);
    CHECK(result.exit_code == 5);
    return result.err;
  };
  CHECK_THAT(notes("gvd-segment", "1000000"),
             StartsWith("gvd-segment: -n 1000000 exceeds the number of faces (5876): this may take about 30 s and "
                        "3.6 GB of memory, at 0.027 ms and 3.6 kB a generator as measured on two cores\n"));
  CHECK_THAT(notes("gvd-lloyd", "1000000"), Contains("this may take about 13 min and 9.6 GB"));
  CHECK_THAT(notes("gvd-remesh", "1000000"), Contains("this may take about 8 min and 15 GB"));
  // Ten seconds need no warning.
  CHECK_THAT(run_command("gvd-segment", data_file("figure.obj") + " -n 6000").err, !Contains("may take"));
}

TEST_CASE("gvd-segment: a page beside a mesh of whole faces names --cut, once") {
  const ScratchFolder scratch;
  const std::string torus = data_file("torus.ply"), page = " --view " + scratch / "a.html",
                    mesh = " -o " + scratch / "a.ply";
  const auto notes = [&](const std::string& options) {
    return run_command("gvd-segment", torus + " -n 5" + options).err;
  };
  CHECK_THAT(notes(page + mesh), Contains("a.html shows the exact borders, and " + scratch / "a.ply" +
                                          " has whole faces; --cut splits them"));
  for (const std::string& options :
       {page, mesh, page + mesh + " --cut", page + mesh + " --labels nearest", page + " -o " + scratch / "a.json"}) {
    CHECK_THAT(notes(options), !Contains("whole faces"));
  }
  const std::string several = run_command("gvd-segment", torus + " " + data_file("figure.obj") + " -n 5 --output-dir " +
                                                             scratch / "out" + " --view")
                                  .err;
  CHECK(several.find("whole faces") == several.rfind("whole faces"));
  CHECK_THAT(several, Contains("whole faces"));
}

}  // namespace gvd::test_command_outputs
