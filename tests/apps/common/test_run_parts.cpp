#include <csignal>
#include <filesystem>

#include "apps/common/run_fixture.hpp"
#include "apps/run_command.hpp"
#include "common/load_input.hpp"
#include "common/process.hpp"
#include "common/run_parts.hpp"
#include "gvd/error.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_run_parts {

using namespace app;
using Catch::Matchers::StartsWith;
using gvd::test::QuietRun;
using gvd::test::read_text;
using gvd::test::ScratchFolder;

Options input(const std::string& path) {
  Options options;
  options.input.path = path;
  return options;
}

MeshPtr load(const Options& options) {
  QuietRun quiet(options);
  return load_input(quiet.run);
}

TEST_CASE("a loaded mesh is reported with its defects") {
  const test::ScratchFolder scratch;
  const std::string path = scratch / "a.obj";
  // The third face repeats the first; no face uses the fifth vertex.
  test::write_text(path, "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 9 9 9\nf 1 2 3\nf 2 4 3\nf 1 2 3\n");
  QuietRun quiet(input(path));
  CHECK(load_input(quiet.run)->mesh.face_count() == 2);
  const auto report = quiet.report();
  CHECK(report["input"]["faces"] == 2);
  CHECK(report["input"]["vertices"] == 4);
  CHECK(report["input"]["boundary_loops"] == 1);
  CHECK(report["input"]["defects"]["duplicate_faces"] == 1);
  CHECK(report["input"]["defects"]["unused_vertices"] == 1);
  CHECK(report["timings_ms"].contains("read"));
  CHECK(report["timings_ms"].contains("check"));
}

TEST_CASE("an error of the check names the input, and the policy is the option's") {
  const test::ScratchFolder scratch;
  const std::string path = scratch / "a.obj";
  test::write_text(path, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 3\n");
  Options options = input(path);
  options.input.on_defect = DefectPolicy::error;
  try {
    load(options);
    FAIL("it was taken");
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::precondition);
    CHECK_THAT(error.what(), StartsWith(path + ": "));
  }
}

TEST_CASE("a format that can't hold the mesh is refused when the mesh is loaded") {
  const test::ScratchFolder scratch;
  test::write_text(scratch / "vast.off", "OFF 3 1 0\n0 0 0\n1e39 0 0\n0 1e39 0\n3 0 1 2\n");
  Options options = input(scratch / "vast.off");
  for (const char* format : {"stl", "glb"}) {
    options.output.files = {scratch / "a." + format};
    CHECK_THROWS_AS(load(options), Error);
    options.output.files = {"-"};
    options.output.formats = {format};
    CHECK_THROWS_AS(load(options), Error);
  }
  options.output.files = {scratch / "a.ply"};
  CHECK_NOTHROW(load(options));
}

const Mesh kGrid = test::make_grid(2, 2);

/// A format of a command's own.
const OwnWriters kOwn{{"json", [](std::ostream& out) { out << "own"; }}};

Options with_files(const std::vector<std::string>& files) {
  Options options;
  options.output.files = files;
  return options;
}

TEST_CASE("each file is written in its format, a command's own format before the shared one") {
  const ScratchFolder scratch;
  QuietRun quiet(with_files({scratch / "a.off", scratch / "a.json"}));
  write_output_files(quiet.run, {kGrid}, kOwn);
  CHECK(read_text(scratch / "a.off").substr(0, 9) == "OFF\n9 8 1");
  CHECK(read_text(scratch / "a.json") == "own");
  CHECK(quiet.report()["timings_ms"].contains("write"));
}

TEST_CASE("an output without curves leaves out what a diagram adds, an ASCII PLY is text") {
  const ScratchFolder scratch;
  const Diagram diagram = compute_diagram(kGrid, {vertex_point(kGrid, VertexId(0)), vertex_point(kGrid, VertexId(8))});
  LabelledMesh mesh{kGrid};
  mesh.diagram = &diagram;
  Options options = with_files({scratch / "a.obj", scratch / "a.ply", scratch / "a.json"});
  QuietRun all(options);
  write_output_files(all.run, mesh);
  CHECK(read_text(scratch / "a.obj").find("\nl ") != std::string::npos);
  options.output.no_curves = options.output.ascii_ply = true;
  QuietRun chosen(options);
  write_output_files(chosen.run, mesh);
  CHECK(read_text(scratch / "a.obj").find("\nl ") == std::string::npos);
  CHECK(read_text(scratch / "a.ply").find("format ascii") != std::string::npos);
  CHECK(nlohmann::json::parse(read_text(scratch / "a.json"))["bisectors"].size() == diagram.bisectors.size());
}

TEST_CASE("a format that the command does not write is refused, and leaves no file") {
  const ScratchFolder scratch;
  QuietRun quiet(with_files({scratch / "a.txt"}));
  CHECK_THROWS_AS(write_output_files(quiet.run, {kGrid}, kOwn), Error);
  CHECK(std::filesystem::is_empty(scratch / ""));
}

TEST_CASE("what is not asked for is not written, computed or timed") {
  QuietRun quiet({});
  write_output_files(quiet.run, {kGrid});
  write_diagram_file(quiet.run, kGrid, {});
  write_view_file(quiet.run, "a", [] {
    FAIL("the scenes were made");
    return std::vector<ViewScene>();
  });
  finish_run(quiet.run, kGrid, {});
  CHECK(quiet.report()["timings_ms"].empty());
}

TEST_CASE("the report tells the peak of memory, and is not written after a signal") {
  const ScratchFolder scratch;
  Options options;
  options.output.report = scratch / "r.json";
  QuietRun quiet(options);
  std::raise(SIGINT);
  CHECK_THROWS_AS(finish_run(quiet.run, kGrid, {}), Error);
  CHECK(!std::filesystem::exists(scratch / "r.json"));
  install_signal_handlers();
  finish_run(quiet.run, kGrid, {});
  CHECK(nlohmann::json::parse(read_text(scratch / "r.json"))["peak_memory_bytes"] > 1000000);
}

}  // namespace gvd::test_run_parts
