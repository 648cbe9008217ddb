// gvd-remesh --carry: the properties and texture coordinates of a PLY or OBJ file on the output.

#include <algorithm>
#include <string>

#include "apps/remesh/run_remesh.hpp"
#include "gvd/mesh_property.hpp"
#include "gvd/read_soup.hpp"
#include "support/catch.hpp"

namespace gvd::test_carry_option {

using namespace test;
using Catch::Matchers::Contains;

/// A tetrahedron with colours, texture coordinates, a list and labels.
constexpr const char* kTetrahedron =
    "ply\nformat ascii 1.0\nelement vertex 4\n"
    "property float x\nproperty float y\nproperty float z\nproperty uchar red\nproperty float u\n"
    "property list uchar int extra\nproperty short part\n"
    "element face 4\nproperty list uchar int vertex_indices\nproperty ushort material\nend_header\n"
    "0 0 0 10 0.5 2 1 2 -3\n1 0 0 20 0.25 0 4\n0 1 0 30 1e6 1 7 5\n0 0 1 255 -1 0 6\n"
    "3 0 2 1 7\n3 0 1 3 7\n3 0 3 2 7\n3 1 2 3 65535\n";

/// Three faces of one chart with u below 0.5, and another face with coordinates of its own.
constexpr const char* kTexturedTetrahedron =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
    "vt 0 0\nvt 0.25 0\nvt 0 0.25\nvt 0.25 0.25\nvt 0.5 0.5\nvt 1 0.5\nvt 0.5 1\n"
    "f 1/5 3/6 2/7\nf 1/1 2/2 4/4\nmtllib in.mtl\nusemtl skin\nf 1/1 4/4 3/3\nf 2/2/1 3/3/1 -1/4/1\n";

TEST_CASE("gvd-remesh --carry: generators at the vertices keep the values of the file") {
  const ScratchFolder scratch;
  write_text(scratch / "in.ply", kTetrahedron);
  for (const char* format : {"", " --ascii-ply"}) {
    run_remesh(scratch / "in.ply" + " --vertices 0,1,2,3 --carry -o " + scratch / "out.ply" + format);
    const auto properties = read_mesh_properties(scratch / "out.ply");
    REQUIRE(properties.size() == 5);
    CHECK(properties[0].name == "red");
    CHECK(properties[0].type == NumberType::uint8);
    CHECK(properties[0].values == std::vector<double>{10, 20, 30, 255});
    CHECK(properties[1].name == "u");
    CHECK(properties[1].values == std::vector<double>{0.5, 0.25, 1e6, -1});
    CHECK(properties[2].name == "extra");
    CHECK(properties[2].count_type == NumberType::uint8);
    CHECK(properties[2].values == std::vector<double>{1, 2, 7});
    CHECK(properties[2].first_value == std::vector<std::size_t>{0, 2, 2, 3, 3});
    CHECK(properties[3].name == "part");
    CHECK(properties[3].values == std::vector<double>{-3, 4, 5, 6});
    CHECK(properties[4].name == "material");
    CHECK(!properties[4].of_vertices);
    CHECK(std::count(properties[4].values.begin(), properties[4].values.end(), 65535) == 1);
  }
}

TEST_CASE(
    "gvd-remesh --carry: the colours of an OBJ's vertices are on PLY output, from a file and from standard input") {
  const ScratchFolder scratch;
  write_text(scratch / "in.obj",
             "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\nv 0 0 1 0.5 0.5 0.5\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  const std::string options = " --vertices 0,1,2,3 --carry -o ";
  run_remesh(scratch / "in.obj" + options + scratch / "out.ply");
  const auto properties = read_mesh_properties(scratch / "out.ply");
  REQUIRE(properties.size() == 3);
  CHECK(properties[0].name == "red");
  CHECK(properties[0].values == std::vector<double>{255, 0, 0, 128});
  CHECK(properties[1].values == std::vector<double>{0, 255, 0, 128});
  CHECK(properties[2].values == std::vector<double>{0, 0, 255, 128});
  run_remesh("- --input-format obj" + options + scratch / "stream.ply" + " < " + scratch / "in.obj");
  CHECK(read_text(scratch / "stream.ply") == read_text(scratch / "out.ply"));
}

TEST_CASE("gvd-remesh: without --carry the output has coordinates and faces only") {
  const ScratchFolder scratch;
  write_text(scratch / "in.ply", kTetrahedron);
  run_remesh(scratch / "in.ply" + " --vertices 0,1,2,3 -o " + scratch / "out.ply");
  CHECK(read_mesh_properties(scratch / "out.ply").empty());
}

TEST_CASE("gvd-remesh --carry: standard input is carried over, too") {
  const ScratchFolder scratch;
  write_text(scratch / "in.ply", kTetrahedron);
  const std::string options = " --vertices 0,1,2,3 --carry -o ";
  run_remesh(scratch / "in.ply" + options + scratch / "file.ply");
  run_remesh("- --input-format ply" + options + scratch / "stream.ply" + " < " + scratch / "in.ply");
  CHECK(read_text(scratch / "stream.ply") == read_text(scratch / "file.ply"));
}

TEST_CASE("gvd-remesh --carry: texture coordinates of an OBJ are on OBJ, PLY and GLB output, materials on OBJ") {
  const ScratchFolder scratch;
  write_text(scratch / "in.obj", kTexturedTetrahedron);
  run_remesh(scratch / "in.obj" + " --vertices 0,1,2,3 --carry -o " + scratch / "out.obj" + " -o " +
             scratch / "out.ply" + " -o " + scratch / "out.glb");
  for (const char* name : {"out.obj", "out.ply", "out.glb"}) {
    INFO(name);
    const Appearance found = read_soup(scratch / name).appearance;
    REQUIRE(found.texture.size() == 12);
    // The faces of vertices 0, 2, 1 and of the others are two charts.
    std::size_t in_second = 0;
    for (const auto& [u, v] : found.texture) in_second += u >= 0.5;
    CHECK(in_second == 3);
    if (name != std::string("out.obj")) continue;
    CHECK(found.materials == std::vector<std::string>{"skin"});
    CHECK(std::count(found.material.begin(), found.material.end(), 0) == 2);
    CHECK(found.material_files == std::vector<std::string>{"in.mtl"});
  }
}

TEST_CASE("gvd-remesh --carry: what has no properties, or can't hold them, is named") {
  const ScratchFolder scratch;
  const CommandResult none =
      run_command("gvd-remesh", data_file("figure.obj") + " -n 30 --carry -o " + scratch / "out.ply");
  CHECK(none.exit_code == 0);
  CHECK_THAT(none.err, Contains("figure.obj: no properties, texture coordinates or materials to carry over"));
  write_text(scratch / "in.ply", kTetrahedron);
  const std::string run = scratch / "in.ply" + " --vertices 0,1,2,3 --carry -o ";
  const CommandResult obj = run_command("gvd-remesh", run + scratch / "out.obj");
  CHECK(obj.exit_code == 0);
  CHECK_THAT(obj.err, Contains("--carry: only .ply holds properties; write one, such as -o FILE.ply"));
  const CommandResult off = run_command("gvd-remesh", run + scratch / "out.off");
  CHECK(off.exit_code == 2);
  CHECK_THAT(off.err, Contains("--carry: only .ply, .obj and .glb hold what is carried over; write one, such as -o"));
}

TEST_CASE("gvd-remesh: without --carry one line says that texture coordinates and materials are left out") {
  const ScratchFolder scratch;
  write_text(scratch / "in.obj", kTexturedTetrahedron);
  const std::string run = scratch / "in.obj" + " --vertices 0,1,2,3 -o " + scratch / "out.obj";
  const std::string told = run_command("gvd-remesh", run).err;
  CHECK_THAT(told, Contains("in.obj: texture coordinates and materials are left out; --carry keeps them"));
  CHECK(read_soup(scratch / "out.obj").appearance.empty());
  CHECK_THAT(run_command("gvd-remesh", run + " --carry").err, !Contains("left out"));
}

}  // namespace gvd::test_carry_option
