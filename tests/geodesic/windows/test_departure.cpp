#include <cmath>
#include <numbers>

#include "geodesic/windows/face_frames.hpp"
#include "geodesic/windows/window.hpp"
#include "mesh/vertex_ring.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_departure {

constexpr double kPi = std::numbers::pi;
/// Three roundings of an angle.
constexpr double kRounding = 1e-8;

TEST_CASE("departure: an angle within a sector of any vertex of up to five half turns") {
  for (double side = 0; side < 4.9 * kPi; side += 0.0931) {
    for (double within = 0; within < std::min(3.1, 5 * kPi - side); within += 0.17) {
      const Departure sum = Departure::of_side(side) + Departure::of_angle(within);
      CHECK(sum.angle() == Approx(side + within).margin(kRounding));
      CHECK((sum - Departure::of_angle(within)) == Departure::of_side(side));
    }
  }
}

TEST_CASE("departure: angles that are added do not change the sector") {
  Departure departure = Departure::of_side(3.5 * kPi);
  for (int i = 0; i < 1000; ++i) {
    const Departure step = Departure::of_angle(0.003 * i);
    departure = i % 2 == 0 ? departure + step : departure - step;
  }
  for (int i = 0; i < 1000; ++i) {
    const Departure step = Departure::of_angle(0.003 * i);
    departure = i % 2 == 0 ? departure - step : departure + step;
  }
  CHECK(departure == Departure::of_side(3.5 * kPi));
}

TEST_CASE("departure: an angle that rounding brings below zero is not a full turn") {
  const Departure sum = Departure::of_side(0) - Departure::of_angle(1e-6);
  CHECK(sum.angle() == Approx(-1e-6).margin(kRounding));
}

TEST_CASE("corner angles: each side follows the one before at the angle of their corner") {
  const Progress silent;
  for (const test::NamedMesh& named : test::small_family()) {
    INFO(named.name);
    const Mesh& mesh = named.mesh;
    const FaceFrames frames(mesh, ParallelChunks(1, {}));
    const CornerAngles angles(mesh, frames, ParallelChunks(1, silent));
    for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
      double sum = 0;
      CHECK(angles.side(mesh.halfedge(VertexId(v))) == Departure::of_side(0));
      for_each_outgoing(mesh, VertexId(v), [&](HalfedgeId h) {
        CHECK(angles.side(h).angle() == Approx(sum).margin(kRounding));
        sum += angles.corner(h).turned();
      });
    }
  }
}

}  // namespace gvd::test_departure
