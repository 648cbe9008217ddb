// gvd-remesh --carry: the properties of a PLY file on the PLY output.

#include <algorithm>
#include <sstream>

#include "apps/run_command.hpp"
#include "gvd/mesh_property.hpp"
#include "support/catch.hpp"

using namespace gvd;
using namespace gvd::test;
using Catch::Matchers::Contains;

namespace {

/// A tetrahedron with colours, texture coordinates, a list and labels.
constexpr const char* kTetrahedron =
    "ply\nformat ascii 1.0\nelement vertex 4\n"
    "property float x\nproperty float y\nproperty float z\nproperty uchar red\nproperty float u\n"
    "property list uchar int extra\nproperty short part\n"
    "element face 4\nproperty list uchar int vertex_indices\nproperty ushort material\nend_header\n"
    "0 0 0 10 0.5 2 1 2 -3\n1 0 0 20 0.25 0 4\n0 1 0 30 1e6 1 7 5\n0 0 1 255 -1 0 6\n"
    "3 0 2 1 7\n3 0 1 3 7\n3 0 3 2 7\n3 1 2 3 65535\n";

}  // namespace

TEST_CASE("gvd-remesh --carry: generators at the vertices keep the values of the file") {
  const ScratchFolder scratch;
  write_text(scratch / "in.ply", kTetrahedron);
  for (const char* format : {"", " --ascii-ply"}) {
    const CommandResult result = run_command(
        "gvd-remesh", scratch / "in.ply" + " --vertices 0,1,2,3 --carry -o " + scratch / "out.ply" + format);
    CAPTURE(result.err);
    REQUIRE(result.exit_code == 0);
    const auto properties = read_mesh_properties(scratch / "out.ply");
    REQUIRE(properties.size() == 4);
    CHECK(properties[0].name == "red");
    CHECK(properties[0].type == NumberType::uint8);
    CHECK(properties[0].values == std::vector<double>{10, 20, 30, 255});
    CHECK(properties[1].name == "u");
    CHECK(properties[1].values == std::vector<double>{0.5, 0.25, 1e6, -1});
    CHECK(properties[2].name == "part");
    CHECK(properties[2].values == std::vector<double>{-3, 4, 5, 6});
    CHECK(properties[3].name == "material");
    CHECK(!properties[3].of_vertices);
    CHECK(std::count(properties[3].values.begin(), properties[3].values.end(), 65535) == 1);
  }
}

TEST_CASE("gvd-remesh: without --carry the output has coordinates and faces only") {
  const ScratchFolder scratch;
  write_text(scratch / "in.ply", kTetrahedron);
  const CommandResult result =
      run_command("gvd-remesh", scratch / "in.ply" + " --vertices 0,1,2,3 -o " + scratch / "out.ply");
  REQUIRE(result.exit_code == 0);
  CHECK(read_mesh_properties(scratch / "out.ply").empty());
}

TEST_CASE("gvd-remesh --carry: what has no properties, or can't hold them, is named") {
  const ScratchFolder scratch;
  const CommandResult none =
      run_command("gvd-remesh", data_file("figure.obj") + " -n 30 --carry -o " + scratch / "out.ply");
  CHECK(none.exit_code == 0);
  CHECK_THAT(none.err, Contains("figure.obj: no properties of vertices or faces to carry over"));
  const CommandResult obj =
      run_command("gvd-remesh", data_file("torus.ply") + " -n 30 --carry -o " + scratch / "out.obj");
  CHECK(obj.exit_code == 2);
  CHECK_THAT(obj.err, Contains("--carry: only PLY files hold properties; write one, such as -o FILE.ply"));
}
