#include "apps/common/steps/run_fixture.hpp"
#include "apps/run_command.hpp"
#include "common/steps/load_input.hpp"
#include "gvd/error.hpp"
#include "support/catch.hpp"

namespace gvd::test_load_input {

using namespace app;
using Catch::Matchers::StartsWith;
using gvd::test::QuietRun;

Options input(const std::string& path) {
  Options options;
  options.input.path = path;
  return options;
}

CheckedMesh load(const Options& options) {
  QuietRun quiet(options);
  return load_input(quiet.run);
}

TEST_CASE("a loaded mesh is reported with its defects") {
  const test::ScratchFolder scratch;
  const std::string path = scratch / "a.obj";
  // The third face repeats the first; no face uses the fifth vertex.
  test::write_text(path, "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 9 9 9\nf 1 2 3\nf 2 4 3\nf 1 2 3\n");
  QuietRun quiet(input(path));
  CHECK(load_input(quiet.run).mesh.face_count() == 2);
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
  options.input.on_defect = "error";
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

}  // namespace gvd::test_load_input
