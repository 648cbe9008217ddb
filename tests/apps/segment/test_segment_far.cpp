// gvd-segment on a mesh in the coordinates of a survey: what its files keep, and what it says of those that don't.

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "apps/run_command.hpp"
#include "gvd/read_soup.hpp"
#include "gvd/soup.hpp"
#include "support/catch.hpp"

namespace gvd::test_segment_far {

using namespace test;
using Catch::Matchers::Contains;

/// A flat square of 20 x 20 quads of size 0.1 at a point.
std::string square_at(double x, double y) {
  std::string text = "OFF\n441 800 0\n";
  for (int i = 0; i <= 20; ++i) {
    for (int k = 0; k <= 20; ++k) text += fmt::format("{} {} 0\n", x + 0.1 * i, y + 0.1 * k);
  }
  for (int i = 0; i < 20; ++i) {
    for (int k = 0; k < 20; ++k) {
      const int a = 21 * i + k, b = a + 21;
      text += fmt::format("3 {} {} {}\n3 {} {} {}\n", a, b, b + 1, a, b + 1, a + 1);
    }
  }
  return text;
}

std::string run(const std::string& arguments) {
  const CommandResult result = run_command("gvd-segment", arguments);
  CAPTURE(arguments, result.err);
  REQUIRE(result.exit_code == 0);
  return result.err;
}

TEST_CASE("gvd-segment far from the origin: .glb and .ply keep the surface, and a note tells what others do to it") {
  const ScratchFolder scratch;
  write_text(scratch / "far.off", square_at(431234.37, 5412345.81));
  std::string files;
  for (const char* name : {"a.ply", "a.obj", "a.off", "a.vtp", "a.glb"}) files += " -o " + scratch / "" + name;
  CHECK_THAT(run(scratch / "far.off" + " -n 5" + files), !Contains("32-bit"));
  const PolygonSoup given = read_soup(scratch / "far.off"), glb = read_soup(scratch / "a.glb");
  REQUIRE(given.corners.size() == glb.corners.size());
  for (std::size_t c = 0; c < given.corners.size(); ++c) {
    const Vec3 apart = glb.positions[std::size_t(glb.corners[c])] - given.positions[std::size_t(given.corners[c])];
    REQUIRE(apart.cwiseAbs().maxCoeff() < 1e-6);
  }
  for (const char* name : {"a.ply", "a.obj", "a.off", "a.vtp"}) {
    const PolygonSoup kept = read_soup(scratch / "" + name);
    CAPTURE(name);
    REQUIRE(kept.positions.size() >= given.positions.size());  // bisectors follow in .obj
    CHECK(std::equal(given.positions.begin(), given.positions.end(), kept.positions.begin()));
  }
  const std::string notes =
      run(scratch / "far.off" + " -n 5 --cut -o " + scratch / "a.stl" + " -o " + scratch / "a.surf.gii");
  for (const std::string format : {"stl", "surf.gii"}) {
    CHECK_THAT(notes, Contains(fmt::format(".{} has 32-bit floats, which move vertices by up to 0.2", format)));
  }
  CHECK_THAT(notes, Contains("faces collapse; .ply, .obj, .off, .coff, .vtp and .vtu keep doubles, .glb the place"));
}

TEST_CASE("gvd-segment near the origin: 32-bit floats are not told") {
  const ScratchFolder scratch;
  write_text(scratch / "near.off", square_at(12, -7));
  CHECK_THAT(run(scratch / "near.off" + " -n 5 --cut -o " + scratch / "a.stl" + " -o " + scratch / "a.glb"),
             !Contains("32-bit"));
}

}  // namespace gvd::test_segment_far
