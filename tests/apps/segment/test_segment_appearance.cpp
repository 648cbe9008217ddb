// Texture coordinates and materials of INPUT in the files of the commands, and the line that says what is left out.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "apps/run_command.hpp"
#include "gvd/read_soup.hpp"
#include "gvd/soup.hpp"
#include "support/catch.hpp"

namespace gvd::test_segment_appearance {

using namespace test;
using Catch::Matchers::Contains;

/// A torus of quadrilaterals with u and v from 0 to 1 round it, so that both have a seam, and two materials.
std::string textured_torus() {
  constexpr int kAround = 16, kAcross = 10;
  constexpr double kTurn = 2 * 3.14159265358979323846;
  std::string text = "mtllib paint box.mtl\n";
  for (int i = 0; i < kAround; ++i) {
    for (int k = 0; k < kAcross; ++k) {
      const double a = kTurn * i / kAround, b = kTurn * k / kAcross, r = 3 + std::cos(b);
      text += fmt::format("v {} {} {}\n", r * std::cos(a), r * std::sin(a), std::sin(b));
    }
  }
  for (int i = 0; i <= kAround; ++i) {
    for (int k = 0; k <= kAcross; ++k) text += fmt::format("vt {} {}\n", i / 16.0, k / 10.0);
  }
  for (int i = 0; i < kAround; ++i) {
    if (i == 0) text += "usemtl red #1\n";
    if (i == kAround / 2) text += "usemtl blue\n";
    for (int k = 0; k < kAcross; ++k) {
      text += "f";
      for (const auto& [x, y] : {std::pair(i, k), {i + 1, k}, {i + 1, k + 1}, {i, k + 1}}) {
        text += fmt::format(" {}/{}", x % kAround * kAcross + y % kAcross + 1, x * (kAcross + 1) + y + 1);
      }
      text += "\n";
    }
  }
  return text;
}

/// u and v of a point of the torus by its angles; on quadrilaterals, which are not flat, they differ by little.
void require_angles(const PolygonSoup& soup) {
  REQUIRE(soup.appearance.texture.size() == soup.corners.size());
  for (std::size_t c = 0; c < soup.corners.size(); ++c) {
    const Vec3& p = soup.positions[static_cast<std::size_t>(soup.corners[c])];
    const auto& [u, v] = soup.appearance.texture[c];
    const double turn = 2 * 3.14159265358979323846;
    const double a = std::atan2(p.y(), p.x()) / turn, b = std::atan2(p.z(), std::hypot(p.x(), p.y()) - 3) / turn;
    const auto apart = [](double x, double y) { return std::abs(x - y - std::round(x - y)); };
    REQUIRE(apart(u, a) < 0.02);
    REQUIRE(apart(v, b) < 0.04);
    REQUIRE((u >= 0 && u <= 1 && v >= -1e-6 && v <= 1 + 1e-6));
  }
  // No face reaches over a seam.
  for (std::size_t p = 0; p < soup.polygon_count(); ++p) {
    for (std::size_t k = 0; k < 2; ++k) {
      const auto at = [&](std::size_t i) { return soup.appearance.texture[soup.first_corner[p] + i][k]; };
      REQUIRE(std::max({at(0), at(1), at(2)}) - std::min({at(0), at(1), at(2)}) < 0.11);
    }
  }
}

/// The first half of the torus is red, and the other half blue.
void require_materials(const PolygonSoup& soup) {
  REQUIRE(soup.appearance.materials.size() == 2);
  CHECK(soup.appearance.material_files == std::vector<std::string>{"paint box.mtl"});
  for (std::size_t p = 0; p < soup.polygon_count(); ++p) {
    double y = 0;
    for (const std::int32_t v : soup.polygon(p)) y += soup.positions[static_cast<std::size_t>(v)].y() / 3;
    const auto material = static_cast<std::size_t>(soup.appearance.material[p]);
    REQUIRE(soup.appearance.materials[material] == (y > 0 ? "red #1" : "blue"));
  }
}

TEST_CASE("gvd-segment: texture coordinates and materials survive, with --cut and without") {
  const ScratchFolder scratch;
  write_text(scratch / "in.obj", textured_torus());
  for (const std::string cut : {"", " --cut"}) {
    const CommandResult result =
        run_command("gvd-segment", scratch / "in.obj" + " -n 9" + cut + " -o " + scratch / "a.obj" + " -o " +
                                       scratch / "a.ply" + " -o " + scratch / "a.glb");
    INFO(cut << result.err);
    REQUIRE(result.exit_code == 0);
    for (const char* name : {"a.obj", "a.ply", "a.glb"}) require_angles(read_soup(scratch / name));
    require_materials(read_soup(scratch / "a.obj"));
    CHECK_THAT(read_text(scratch / "a.obj"), Contains("\ng region_8\nusemtl ") || Contains("\ng region_8\nf "));
    CHECK_THAT(result.err, Contains("in.obj: left out: materials in .ply and .glb\n"));
    CHECK(!std::filesystem::exists(scratch / "a.mtl"));
  }
}

TEST_CASE("gvd-lloyd and gvd-distance keep texture coordinates and materials, too") {
  const ScratchFolder scratch;
  write_text(scratch / "in.obj", textured_torus());
  run_command("gvd-distance", scratch / "in.obj" + " --from 0 --isolines 1 -o " + scratch / "a.obj");
  require_angles(read_soup(scratch / "a.obj"));
  require_materials(read_soup(scratch / "a.obj"));
  const std::vector<std::string> built = built_commands();
  if (std::find(built.begin(), built.end(), "gvd-lloyd") == built.end()) return;
  run_command("gvd-lloyd", scratch / "in.obj" + " -n 9 --iterations 1 -o " + scratch / "b.obj");
  require_angles(read_soup(scratch / "b.obj"));
  require_materials(read_soup(scratch / "b.obj"));
}

TEST_CASE("gvd-segment: one line says what of the appearance is left out") {
  const ScratchFolder scratch;
  std::filesystem::create_directory(scratch / "other");
  write_text(scratch / "in.obj", textured_torus());
  const auto told = [&](const std::string& options) {
    const CommandResult result = run_command("gvd-segment", scratch / "in.obj" + " -n 3 -o " + scratch / "" + options);
    CHECK(result.exit_code == 0);
    return result.err;
  };
  CHECK_THAT(told("a.stl -o " + scratch / "a.off"),
             Contains("in.obj: left out: texture coordinates in .stl and .off; materials in .stl and .off\n"));
  CHECK_THAT(told("a.obj -o " + scratch / "a.json"), !Contains("left out"));
  CHECK_THAT(told("other/a.obj"), Contains("names the materials of paint box.mtl, which is beside "));
  const std::string painted = told("a.obj --region-materials");
  CHECK_THAT(painted, !Contains("left out"));
  CHECK_THAT(read_text(scratch / "a.mtl"), Contains("newmtl region_0\n"));
  require_angles(read_soup(scratch / "a.obj"));
  const CommandResult idle =
      run_command("gvd-segment", scratch / "in.obj" + " -n 3 --region-materials -o " + scratch / "a.ply");
  CHECK(idle.exit_code == 2);
  CHECK_THAT(idle.err, Contains("--region-materials: only .obj holds materials; write one"));
}

TEST_CASE("gvd-segment: materials of regions do not replace those that the input names") {
  const ScratchFolder scratch;
  write_text(scratch / "paint box.mtl", "newmtl blue\n");
  write_text(scratch / "in.obj", textured_torus());
  for (const std::string command : {"gvd-segment", "gvd-lloyd"}) {
    const std::vector<std::string> built = built_commands();
    if (std::find(built.begin(), built.end(), command) == built.end()) continue;
    write_text(scratch / "bare.obj", "mtllib paint box.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\nf 1 2 3\nf 2 4 3\n");
    const CommandResult result = run_command(command, scratch / "bare.obj" + " -n 2 -o '" + scratch / "paint box.obj'");
    CHECK(result.exit_code == 2);
    CHECK_THAT(result.err, Contains("its materials would replace paint box.mtl"));
    // The words of a line are files where the whole line is none.
    CHECK(run_command(command, scratch / "bare.obj" + " -n 2 -q -o " + scratch / "box.obj").exit_code == 0);
    write_text(scratch / "two.obj", "mtllib red.mtl blue.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\nf 1 2 3\nf 2 4 3\n");
    CHECK_THAT(run_command(command, scratch / "two.obj" + " -n 2 -o " + scratch / "blue.obj").err,
               Contains("its materials would replace blue.mtl"));
  }
  const std::string painted = scratch / "in.obj" + " -n 3 -o '" + scratch / "paint box.obj'";
  CHECK(run_command("gvd-segment", painted + " --region-materials").exit_code == 2);
  CHECK(read_text(scratch / "paint box.mtl") == "newmtl blue\n");
  CHECK(run_command("gvd-segment", painted).exit_code == 0);
  CHECK(read_text(scratch / "paint box.mtl") == "newmtl blue\n");
}

TEST_CASE("gvd-segment: a file with bad texture coordinates gets one line") {
  const ScratchFolder scratch;
  write_text(scratch / "in.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/7 3/-5\n");
  const CommandResult result = run_command("gvd-segment", scratch / "in.obj -n 1 -o " + scratch / "a.obj");
  CHECK(result.exit_code == 0);
  CHECK_THAT(result.err,
             Contains("in.obj: 2 corners refer to texture coordinates that are missing or no numbers: left out\n"));
  CHECK(read_text(scratch / "a.obj").find("vt ") != std::string::npos);
}

}  // namespace gvd::test_segment_appearance
