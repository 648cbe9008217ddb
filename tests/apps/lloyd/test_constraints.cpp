// gvd-lloyd with generators that stay, on features, and with densities.

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "apps/run_command.hpp"
#include "support/catch.hpp"

namespace gvd::test_constraints {

using namespace test;
using Catch::Matchers::Contains;

CommandResult lloyd(const std::string& arguments) { return run_command("gvd-lloyd", arguments); }

/// The lines of a list of generators, without the first one.
std::vector<std::string> lines_of(const std::string& path) {
  std::vector<std::string> lines;
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) {
    if (!line.empty() && line[0] != '#') lines.push_back(line);
  }
  return lines;
}

TEST_CASE("gvd-lloyd --fixed: these generators come first and stay, and -n counts them") {
  const ScratchFolder scratch;
  write_text(scratch / "fixed.txt", "5\n77\n200\n");
  const std::string fixed = " --fixed " + scratch / "fixed.txt" + " --iterations 8 -q -o ";
  REQUIRE(lloyd(data_file("figure.obj") + " -n 12" + fixed + scratch / "a.txt").exit_code == 0);
  REQUIRE(lloyd(data_file("figure.obj") + " -n 12 --seed 5" + fixed + scratch / "b.txt").exit_code == 0);
  const auto a = lines_of(scratch / "a.txt"), b = lines_of(scratch / "b.txt");
  REQUIRE(a.size() == 12);
  REQUIRE(b.size() == 12);
  for (std::size_t i = 0; i < 3; ++i) CHECK(a[i] == b[i]);
  CHECK(a[4] != b[4]);
  const CommandResult few = lloyd(data_file("figure.obj") + " -n 2" + fixed + scratch / "c.txt");
  CHECK(few.exit_code == 4);
  CHECK_THAT(few.err, Contains("2 generators are requested, but 3 are fixed or on features; ask for more generators"));
}

TEST_CASE("gvd-lloyd --fixed: its list has a format of its own") {
  const ScratchFolder scratch;
  write_text(scratch / "fixed.txt", "5\n77\n");
  write_text(scratch / "list", "vertex\n1000\n2000\n");
  const std::string options = " --generators-format csv --iterations 2 -q -o ";
  REQUIRE(lloyd(data_file("figure.obj") + " --generators " + scratch / "list" + " --fixed " + scratch / "fixed.txt" +
                options + scratch / "a.txt")
              .exit_code == 0);
  CHECK(lines_of(scratch / "a.txt").size() == 4);
}

TEST_CASE("gvd-lloyd --features, --keep-boundary: corners and creases have their generators") {
  const ScratchFolder scratch;
  const std::string run = " -n 60 --iterations 5 -o " + scratch / "out.txt";
  const CommandResult plate = lloyd(data_file("plate.stl") + " --features 40" + run);
  REQUIRE(plate.exit_code == 0);
  CHECK_THAT(plate.err, Contains("8 fixed"));
  CHECK(lines_of(scratch / "out.txt").size() == 60);
  const CommandResult half = lloyd(data_file("half_sphere.off") + " --keep-boundary" + run);
  REQUIRE(half.exit_code == 0);
  CHECK_THAT(half.err, Contains("0 fixed"));
  CHECK_THAT(half.err, !Contains(" 0 on creases"));
  // A list says where generators are; those on features stay there.
  const CommandResult again = lloyd(data_file("half_sphere.off") + " --keep-boundary --generators " +
                                    scratch / "out.txt" + " --iterations 5 -o " + scratch / "again.txt");
  REQUIRE(again.exit_code == 0);
  CHECK(half.err.substr(0, half.err.find('\n')) == again.err.substr(0, again.err.find('\n')));
  CHECK_THAT(lloyd(data_file("plate.stl") + " --features 0" + run).err, Contains("above 0 and at most 180"));
}

TEST_CASE("gvd-lloyd --density: curvature, files for vertices and faces, and properties of a PLY file") {
  const ScratchFolder scratch;
  const std::string run = " -n 20 --iterations 4 -q -o " + scratch / "out.txt" + " --density ";
  CHECK(lloyd(data_file("figure.obj") + run + "curvature").exit_code == 0);
  write_text(scratch / "triangle.off", "OFF 4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n");
  const std::string few = " -n 2 --iterations 4 -q -o " + scratch / "out.txt" + " --density ";
  write_text(scratch / "vertices.txt", "1 2\n3.5 4\n");
  write_text(scratch / "faces.txt", "1\n5\n");
  for (const std::string file : {"vertices.txt", "faces.txt"}) {
    CHECK(lloyd(scratch / "triangle.off" + few + scratch / file).exit_code == 0);
  }
  write_text(scratch / "wrong.txt", "1 2 3\n");
  const CommandResult wrong = lloyd(scratch / "triangle.off" + few + scratch / "wrong.txt");
  CHECK(wrong.exit_code == 3);
  CHECK_THAT(wrong.err, Contains("wrong.txt: 3 numbers; give one for each vertex (4) or each face (2)"));
  write_text(scratch / "zero.txt", "1 0\n");
  CHECK_THAT(lloyd(scratch / "triangle.off" + few + scratch / "zero.txt").err,
             Contains("the density of face 1 is 0; give finite numbers above 0"));
  write_text(scratch / "word.txt", "1\ntwo\n");
  CHECK_THAT(lloyd(scratch / "triangle.off" + few + scratch / "word.txt").err,
             Contains("word.txt:2: 'two' is not a number"));
  write_text(scratch / "q.ply",
             "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
             "property float quality\nelement face 2\nproperty list uchar int vertex_indices\nproperty float weight\n"
             "end_header\n0 0 0 1\n1 0 0 2\n1 1 0 3\n0 1 0 4\n3 0 1 2 7\n3 0 2 3 8\n");
  CHECK(lloyd(scratch / "q.ply" + few + "quality").exit_code == 0);
  CHECK(lloyd(scratch / "q.ply" + few + "weight").exit_code == 0);
  write_text(scratch / "strips.ply",
             "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
             "element face 1\nproperty list uchar int vertex_indices\nproperty float weight\n"
             "element tristrips 1\nproperty list int int vertex_indices\n"
             "end_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 2 0\n3 0 1 2 7\n4 0 2 3 4\n");
  const CommandResult strips = lloyd(scratch / "strips.ply" + few + "weight");
  CHECK(strips.exit_code == 3);
  CHECK_THAT(strips.err, Contains("property weight: 1 number for"));
  const CommandResult none = lloyd(scratch / "q.ply" + few + "mass");
  CHECK(none.exit_code == 3);
  CHECK_THAT(none.err, Contains("--density mass: there is no such file, and"));
}

TEST_CASE(
    "gvd-lloyd --within, --mask: generators keep to regions, and the report and the page are those of the surface") {
  const ScratchFolder scratch;
  const std::string mesh = data_file("figure.obj");
  REQUIRE(run_command("gvd-segment", mesh + " -q --levels 2,4 --face-labels " + scratch / "l.csv").exit_code == 0);
  const std::string run = mesh + " -n 9 --iterations 5 -o " + scratch / "a.json" + " --verify --report " +
                          scratch / "r.json" + " --view " + scratch / "a.html --within " + scratch / "l.csv";
  const CommandResult made = lloyd(run);
  CAPTURE(made.err);
  REQUIRE(made.exit_code == 0);
  CHECK_THAT(made.err, Contains("inside 4 regions of 4 connected parts"));
  const auto report = nlohmann::json::parse(std::ifstream(scratch / "r.json"));
  CHECK(report["results"]["within"]["regions"] == 4);
  CHECK(report["results"]["within"]["left_out_faces"] == 0);
  // The labels of the last level are 0 to 3: all but region 0 are left out.
  const CommandResult masked = lloyd(mesh + " -n 3 --iterations 5 -o " + scratch / "b.ply --mask " + scratch / "l.csv");
  CHECK(masked.exit_code == 0);
  CHECK_THAT(masked.err, Contains("inside 1 region of 1 connected part; "));
  CHECK_THAT(lloyd(mesh + " -n 3 --features 30 -o " + scratch / "b.ply --mask " + scratch / "l.csv").err,
             Contains("error: --features would put generators into the faces that are left out; leave it out"));
  CHECK_THAT(lloyd(mesh + " -n 3 --coarse 500 -o " + scratch / "b.ply --mask " + scratch / "l.csv").err,
             Contains("--coarse and --mask exclude each other: there is no copy of regions; keep one"));
}

}  // namespace gvd::test_constraints
