// Properties of every command: files, options, exit codes, streams.

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "apps/run_command.hpp"
#include "support/catch.hpp"

using namespace gvd::test;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

std::ptrdiff_t line_count(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

/// An error: this exit code, nothing on stdout, one line on stderr.
void require_error(const std::string& name, const std::string& arguments, int code, const std::string& part) {
  CAPTURE(name, arguments);
  const CommandResult result = run_command(name, arguments);
  CAPTURE(result.err);
  CHECK(result.exit_code == code);
  CHECK(result.out.empty());
  CHECK(line_count(result.err) == 1);
  CHECK_THAT(result.err, StartsWith(name + ": error: "));
  CHECK_THAT(result.err, Contains(part));
}

}  // namespace

TEST_CASE("commands: a run reports what it did, and is silent when asked") {
  const ScratchFolder scratch;
  for (const std::string& name : built_commands()) {
    CAPTURE(name);
    const std::string report = scratch / (name + ".json");
    const CommandResult result = run_command(name, data_file("figure.obj") + " -n 40 -q --report " + report);
    CHECK(result.exit_code == 0);
    CHECK(result.out.empty());
    CHECK(result.err.empty());
    const auto content = nlohmann::json::parse(read_text(report));
    CHECK(content["schema"] == "gvd-report/1");
    CHECK(content["command"] == name);
    CHECK(content["seed"] == 0);
    CHECK(content["options"]["n"] == 40);
    CHECK(content["input"]["faces"].get<int>() > 1000);
    CHECK(content["generators"].size() >= 40);
    CHECK(content["diagram"]["unresolved_ends"] == 0);
    CHECK(content["peak_memory_bytes"].get<double>() > 1e6);
    CHECK(content["timings_ms"].contains(name == "gvd-lloyd" ? "relaxation" : "diagram"));
    CHECK(content["timings_ms"].contains("dual") == (name == "gvd-remesh"));
  }
}

TEST_CASE("commands: the report names the method and what belongs to it") {
  const ScratchFolder scratch;
  const std::string report = scratch / "r.json";
  const auto run_with = [&](const std::string& name, const std::string& options) {
    CAPTURE(name, options);
    const CommandResult result =
        run_command(name, data_file("torus.ply") + " -n 20 -q --report " + report + " " + options);
    CAPTURE(result.err);
    REQUIRE(result.exit_code == 0);
    return nlohmann::json::parse(read_text(report));
  };
  for (const std::string& name : built_commands()) {
    CAPTURE(name);
    const auto exact = run_with(name, ""), fine = run_with(name, "--method exact --chord-tolerance 1e-6"),
               paper = run_with(name, "--method gbgvd"), planar = run_with(name, "--method gbgvd --front planar");
    CHECK(exact["options"]["method"] == "exact");
    CHECK(exact["options"]["chord_tolerance"] == 1e-4);
    CHECK(exact["options"]["front"].is_null());
    CHECK(exact["diagram"]["straightened_faces"] == 0);
    CHECK(exact["diagram"]["relabelled_vertices"] == 0);
    CHECK(fine["options"]["chord_tolerance"] == 1e-6);
    CHECK(paper["options"]["method"] == "gbgvd");
    CHECK(paper["options"]["chord_tolerance"].is_null());
    CHECK(paper["options"]["front"] == "circle");
    CHECK(planar["options"]["front"] == "planar");
    // Four different diagrams: each option has its effect.
    CHECK(exact["diagram"]["length"] != fine["diagram"]["length"]);
    CHECK(exact["diagram"]["length"] != paper["diagram"]["length"]);
    CHECK(paper["diagram"]["length"] != planar["diagram"]["length"]);
  }
}

TEST_CASE("commands: help and version go to standard output") {
  for (const std::string& name : built_commands()) {
    const CommandResult help = run_command(name, "--help");
    CHECK(help.exit_code == 0);
    CHECK(help.err.empty());
    for (const char* part :
         {"Examples:", "--generators", "--on-defect", "--config", "--chord-tolerance", "--report", "Exit codes:"}) {
      CHECK_THAT(help.out, Contains(part));
    }
    const CommandResult version = run_command(name, "--version");
    CHECK(version.exit_code == 0);
    CHECK_THAT(version.out, StartsWith(name + " "));
    CHECK(line_count(version.out) == 1);
    CHECK(run_command(name, "--help > /dev/full").exit_code == 6);
  }
}

TEST_CASE("commands: a bad option is a usage error") {
  const std::string mesh = data_file("torus.ply");
  for (const std::string& name : built_commands()) {
    require_error(name, "", 2, "INPUT");
    require_error(name, mesh, 2, "no generators");
    require_error(name, mesh + " -n 5 --radius 1", 2, "-n and --radius");
    require_error(name, mesh + " -n five", 2, "five");
    require_error(name, mesh + " -n 5 --method other", 2, "exact|gbgvd");
    require_error(name, mesh + " -n 5 --front planar", 2, "add --method gbgvd");
    require_error(name, mesh + " -n 5 --method gbgvd --chord-tolerance 1e-3", 2, "--chord-tolerance");
    require_error(name, mesh + " -n 5 --chord-tolerance 0", 2, "'0' is not a finite number above 0");
    require_error(name, mesh + " -n 5 --chord-tolerance 1e-11", 2,
                  "--chord-tolerance 1e-11: a bisector is known to 1e-10 mean edge lengths only");
    require_error(name, mesh + " -n 5 --no-such-option", 2, "--no-such-option");
    require_error(name, mesh + " -n 5 -o picture.bmp", 2, "picture.bmp");
    require_error(name, "- -n 5", 2, "--input-format");
    require_error(name, mesh + " -n 5 --config /nonexistent.toml", 2, "/nonexistent.toml");
  }
}

TEST_CASE("commands: a bad file is refused in one line that names it") {
  const ScratchFolder scratch;
  const auto file = [&](const std::string& name, const std::string& text) {
    write_text(scratch / name, text);
    return scratch / name;
  };
  const std::string torus = read_text(data_file("torus.ply"));
  const std::vector<std::pair<std::string, int>> bad{
      {scratch / "missing.obj", 3},
      {"/tmp", 3},
      {file("empty.obj", ""), 3},
      {file("empty.ply", ""), 3},
      {file("words.obj", "this is no mesh\n"), 3},
      {file("words.ply", "this is no mesh\n"), 3},
      {file("bytes.stl", std::string(100, '\xff')), 3},
      {file("short.ply", torus.substr(0, torus.size() / 2)), 3},
      {file("index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n"), 3},
      {file("nan.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n"), 4},
      {file("point.obj", "v 0 0 0\nv 0 0 0\nv 0 0 0\nf 1 2 3\n"), 4},
  };
  for (const std::string& name : built_commands()) {
    for (const auto& [path, code] : bad) require_error(name, path + " -n 1", code, path);
    require_error(name, file("mesh.xyz", "0 0 0\n") + " -n 1", 3, "name the format with --input-format");
    require_error(name, "- --input-format off -n 1 < " + bad[5].first, 3, "standard input");
    require_error(name, "- --input-format off -n 1", 3, "standard input");
  }
}

TEST_CASE("commands: a bad list of generators is refused in one line") {
  const ScratchFolder scratch;
  const std::string mesh = data_file("torus.ply");
  const auto refused = [&](const std::string& text, int code, const std::string& part) {
    write_text(scratch / "list.txt", text);
    for (const std::string& name : built_commands()) {
      require_error(name, mesh + " --max-snap 0.01 --generators " + scratch / "list.txt", code, part);
    }
  };
  refused("1\n2\nthree\n", 3, "list.txt:3: ");
  refused("", 3, "list.txt:1: ");
  refused("1\n99999999\n", 4, "list.txt:2: ");
  refused("5\n6\n5\n", 4, "generator 2 is in the same place as generator 0");
  refused("p 9 9 9\n", 4, "list.txt:1: ");
  for (const std::string& name : built_commands()) {
    require_error(name, mesh + " --generators " + scratch / "missing.txt", 3, "missing.txt");
    require_error(name, mesh + " --generators " + scratch / "", 3, "is a directory");
    require_error(name, mesh + " --vertices 1,99999999", 4, "99999999");
  }
}

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
    require_error(name, start + "-o /proc/x.ply", 6, "/proc/x.ply");
    require_error(name, start + "-o " + scratch / "folder.ply", 6, "is a directory");
    require_error(name, start + "-o " + scratch / "none/a.ply", 6, "create it first");
    require_error(name, start + "-o " + scratch / "c.obj", 6, "c.mtl: is a directory");
    require_error(name, start + "-o a.obj --diagram ./a.mtl", 2, "two options name this file");
    require_error(name, start + "--report " + scratch / "options.toml", 2, "this is the file that is read");
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

TEST_CASE("commands: a file that grows too large is one line, and leaves nothing") {
  const ScratchFolder scratch;
  write_text(scratch / "a.ply", "old");
  for (const std::string& name : built_commands()) {
    // Long enough for any of the three: 1 is 512 bytes.
    const std::string run = "ulimit -f 1; exec '" + std::string(GVD_BIN_DIR) + "/" + name + "' " +
                            data_file("figure.obj") + " -n 40 -q -o " + scratch / "a.ply";
    const CommandResult result = run_command("/bin/sh", "-c \"" + run + "\"");
    CAPTURE(name, result.err);
    CHECK(result.exit_code == 6);
    CHECK(line_count(result.err) == 1);
    CHECK_THAT(result.err, StartsWith(name + ": error: cannot write ") && Contains("a.ply"));
    CHECK(read_text(scratch / "a.ply") == "old");
  }
  CHECK(std::distance(std::filesystem::directory_iterator(scratch / ""), {}) == 1);
}

TEST_CASE("commands: a reader that goes away ends the run without a word") {
  for (const std::string& name : built_commands()) {
    const std::string command = "'" + std::string(GVD_BIN_DIR) + "/" + name + "' ";
    const auto piped = [&](const std::string& arguments) {
      return run_command("/bin/bash", "-c \"" + command + arguments + " | true; echo \\${PIPESTATUS[0]}\"");
    };
    // More than a pipe holds.
    const CommandResult data = piped(data_file("figure.obj") + " -n 400 -q -o - --output-format json");
    CAPTURE(name);
    CHECK(data.out == "141\n");
    CHECK(data.err.empty());
  }
}

TEST_CASE("commands: closed streams are not taken by the files of the run") {
  const ScratchFolder scratch;
  for (const std::string& name : built_commands()) {
    CAPTURE(name);
    const std::string arguments =
        data_file("figure.obj") + " -n 40 -o " + scratch / "a.off" + " --report " + scratch / "r.json";
    CHECK(run_command(name, arguments + " <&- >&- 2>&-").exit_code == 0);
    CHECK_THAT(read_text(scratch / "a.off"), !Contains(name));
    CHECK(nlohmann::json::parse(read_text(scratch / "r.json"))["command"] == name);
  }
}

TEST_CASE("commands: no binary goes to a terminal, but text does") {
  for (const std::string& name : built_commands()) {
    CAPTURE(name);
    const auto shown = [&](const std::string& format) {
      return run_on_terminal(name, {data_file("figure.obj"), "-n", "40", "-q", "-o", "-", "--output-format", format});
    };
    for (const char* format : {"ply", "stl", "glb"}) {
      const CommandResult result = shown(format);
      CHECK(result.exit_code == 2);
      CHECK_THAT(result.err,
                 Contains(std::string("-o -: .") + format + " is binary, and standard output is a terminal"));
      CHECK(line_count(result.err) == 1);
    }
    CHECK_THAT(shown("off").err, StartsWith("OFF") || StartsWith("COFF"));
  }
}

TEST_CASE("commands: generators without a face are named in one line, all of them in the report") {
  const ScratchFolder scratch;
  const std::string report = scratch / "r.json";
  const CommandResult result = run_command("gvd-segment", data_file("plate.stl") + " -n 3000 --report " + report);
  CHECK(result.exit_code == 0);
  const auto unowned = nlohmann::json::parse(read_text(report))["results"]["generators_without_face"];
  REQUIRE(unowned.size() > 8);
  CHECK_THAT(result.err, Contains(std::to_string(unowned.size()) + " of the generators own no face"));
  CHECK_THAT(result.err, Contains(", ...\n"));
  CHECK(line_count(result.err) < 8);
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

TEST_CASE("commands: a covering radius far too small is refused at once") {
  for (const std::string& name : built_commands()) {
    for (const char* radius : {"1e-300", "1e-9", "1e-4"}) {
      require_error(name, data_file("torus.ply") + " --radius " + radius, 4, "too small for this surface");
    }
  }
}

TEST_CASE("commands: no output replaces a file that is read") {
  namespace fs = std::filesystem;
  const ScratchFolder scratch;
  const std::string mesh = scratch / "mesh.ply", list = scratch / "list.txt";
  fs::copy_file(data_file("torus.ply"), mesh);
  write_text(list, "1\n5\n");
  fs::create_symlink(mesh, scratch / "link.ply");
  fs::create_hard_link(mesh, scratch / "hard.ply");
  fs::create_directory(scratch / "folder");
  const std::string before = read_text(mesh), what = "this is the file that is read";
  for (const std::string& name : built_commands()) {
    for (const char* spelling : {"mesh.ply", "./mesh.ply", "folder/../mesh.ply", "link.ply", "hard.ply"}) {
      const std::string path = scratch / spelling;
      for (const char* option : {"-o", "--report", "--diagram", "--view"}) {
        require_error(name, mesh + " -n 20 " + option + " " + path, 2, path + ": " + what);
      }
      require_error(name, path + " -n 20 -o " + mesh, 2, mesh + ": " + what);
      require_error(name, "- --input-format ply -n 20 -o " + path + " < " + mesh, 2, path + ": " + what);
    }
    require_error(name, mesh + " --generators " + list + " --report " + list, 2, list + ": " + what);
  }
  CHECK(read_text(mesh) == before);
  CHECK(read_text(list) == "1\n5\n");
}

TEST_CASE("commands: standard output carries data only, and standard input is read") {
  const std::string arguments = "- --input-format off -n 20 -o - < " + data_file("half_sphere.off");
  for (const std::string& name : built_commands()) {
    CAPTURE(name);
    const CommandResult piped = run_command(name, arguments);
    CHECK(piped.exit_code == 0);
    CHECK(!piped.out.empty());
    CHECK(piped.out.find("gvd-") != 0);
    const CommandResult json = run_command(name, "--output-format json " + arguments);
    CHECK(nlohmann::json::parse(json.out).is_object());
  }
}

TEST_CASE("commands: a list of generators comes through a pipe, in any format") {
  const ScratchFolder scratch;
  const std::string mesh = data_file("figure.obj"), made = mesh + " -n 12 -q --iterations 1 -o - ";
  for (const char* format : {"txt", "csv", "json"}) {
    CAPTURE(format);
    const CommandResult file =
        run_command("gvd-lloyd", made + "--output-format " + format + " > " + scratch / "list." + format);
    REQUIRE(file.exit_code == 0);
    const auto labels_of = [&](const std::string& arguments) {
      const CommandResult result = run_command("gvd-segment", mesh + " -q -o - " + arguments);
      CAPTURE(arguments, result.err);
      CHECK(result.exit_code == 0);
      return result.out;
    };
    const std::string list = scratch / "list." + format;
    const std::string expected = labels_of("--generators " + list);
    CHECK(labels_of("--generators - < " + list) == expected);
    const std::string same = std::string(format) == "txt" ? "text" : format;
    CHECK(labels_of("--generators - --generators-format " + same + " < " + list) == expected);
  }
  require_error("gvd-segment", mesh + " --generators - --generators-format json < " + scratch / "list.csv", 3,
                "standard input");
  require_error("gvd-segment", mesh + " --generators -", 3, "standard input:1: the list holds no generator");
  require_error("gvd-segment", "- --input-format obj --generators -", 2,
                "INPUT and --generators are both standard input");
  require_error("gvd-segment", mesh + " -n 3 --generators-format json", 2, "--generators-format does nothing here");
  const std::string list = scratch / "list.csv";
  require_error("gvd-segment", mesh + " --generators - --report " + list + " < " + list, 2,
                "this is the file that is read");
}

TEST_CASE("commands: the same call gives the same bytes") {
  const ScratchFolder scratch;
  for (const std::string& name : built_commands()) {
    std::string arguments = data_file("figure.obj") + " -q -n 40 --seed 3";
    std::string again = arguments + " --threads 1";
    const std::vector<std::string> files{"a.ply", "a.obj", "a.off", "a.stl", "a.vtp", "a.glb", "a.json"};
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

TEST_CASE("commands: options come from a file too") {
  const ScratchFolder scratch;
  write_text(scratch / "options.toml", "n = 12\nseed = 4\nquiet = true\nreport = \"" + scratch / "r.json" + "\"\n");
  for (const std::string& name : built_commands()) {
    const CommandResult result = run_command(name, data_file("figure.obj") + " --config " + scratch / "options.toml");
    CAPTURE(name, result.err);
    CHECK(result.exit_code == 0);
    CHECK(result.err.empty());
    CHECK(nlohmann::json::parse(read_text(scratch / "r.json"))["options"]["n"] == 12);
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

TEST_CASE("commands: the command line's generators take the place of those of the file") {
  const ScratchFolder scratch;
  write_text(scratch / "o.toml", "input = \"" + data_file("figure.obj") +
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

TEST_CASE("commands: bars are drawn on a terminal only") {
  for (const std::string& name : built_commands()) {
    const std::vector<std::string> arguments{data_file("figure.obj"), "-n", "40"};
    const auto on_terminal = [&](const char* terminal, const char* no_color) {
      setenv("TERM", terminal, 1);
      setenv("NO_COLOR", no_color, 1);
      return run_on_terminal(name, arguments).err;
    };
    const std::string bar = "\r\x1b[K", colour = "\x1b[36m";
    const std::string with = on_terminal("xterm", "");
    CHECK_THAT(with, Contains(bar) && Contains(colour) && Contains("%"));
    CHECK_THAT(on_terminal("xterm", "1"), Contains(bar) && !Contains(colour));
    CHECK_THAT(on_terminal("dumb", ""), !Contains("\x1b"));
    CHECK_THAT(run_command(name, data_file("figure.obj") + " -n 40").err, !Contains("\r") && !Contains("\x1b"));
  }
}

TEST_CASE("commands: an interrupted run exits with 130 and leaves the old file") {
  const ScratchFolder scratch;
  for (const std::string& name : built_commands()) {
    for (const int signal : {SIGINT, SIGTERM}) {
      CAPTURE(name, signal);
      write_text(scratch / "old.json", "old");
      const CommandResult result =
          run_interrupted(name, {"-", "--input-format", "obj", "-n", "1", "-o", scratch / "old.json"}, signal);
      CHECK(result.exit_code == 130);
      CHECK(line_count(result.err) == 1);
      CHECK(read_text(scratch / "old.json") == "old");
    }
  }
}
