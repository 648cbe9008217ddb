#include <csignal>
#include <filesystem>

#include "apps/common/steps/run_fixture.hpp"
#include "apps/run_command.hpp"
#include "common/steps/write_outputs.hpp"
#include "gvd/error.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_write_outputs {

using namespace app;
using gvd::test::QuietRun;
using gvd::test::read_text;
using gvd::test::ScratchFolder;

const Mesh kGrid = test::make_grid(2, 2);

/// A format of a command's own.
const std::map<std::string, OutputWriter> kOwn{{"json", [](std::ostream& out) { out << "own"; }}};

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

TEST_CASE("an output without curves leaves out what a diagram adds; an ASCII PLY is text") {
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
  write_report_file(quiet.run);
  CHECK(quiet.report()["timings_ms"].empty());
}

TEST_CASE("the report tells the peak of memory, and is not written after a signal") {
  const ScratchFolder scratch;
  Options options;
  options.output.report = scratch / "r.json";
  QuietRun quiet(options);
  std::raise(SIGINT);
  CHECK_THROWS_AS(write_report_file(quiet.run), Error);
  CHECK(!std::filesystem::exists(scratch / "r.json"));
  install_signal_handlers();
  write_report_file(quiet.run);
  CHECK(nlohmann::json::parse(read_text(scratch / "r.json"))["peak_memory_bytes"] > 1000000);
}

}  // namespace gvd::test_write_outputs
