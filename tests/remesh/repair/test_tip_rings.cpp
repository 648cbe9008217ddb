// Rings of three generators at the same distance from a tip.
#include <cmath>
#include <numbers>

#include "repair/cell_topology.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_tip_rings {

const GeneratorId kTip(0), kAnnulus(1);

/// The tip and one generator on the side, whose cell surrounds that of the tip, and one in the middle of the base.
std::vector<SurfacePoint> on_spike(const Mesh& spike, double distance) {
  return {vertex_point(spike, VertexId(0)),
          make_surface_point(FaceId(0), {1 - distance, 0.3 * distance, 0.7 * distance}),
          vertex_point(spike, VertexId(spike.vertex_count() - 1))};
}

std::vector<SurfacePoint> with(std::vector<SurfacePoint> points, const std::vector<SurfacePoint>& more) {
  points.insert(points.end(), more.begin(), more.end());
  return points;
}

TEST_CASE("tip rings: the total angle of a vertex") {
  const Mesh spike = test::make_pyramid(25, 5);
  CHECK(total_angle(spike, VertexId(0)) == Approx(25 * std::numbers::pi / 180));
  CHECK(total_angle(spike, VertexId(6)) == Approx(2 * std::numbers::pi));
  CHECK(total_angle(test::make_grid(1, 1), VertexId(0)) == Approx(std::numbers::pi / 2));
}

TEST_CASE("tip rings: a cell that surrounds a tip gets two points as far from the tip as its generator") {
  for (const double angle : {120, 60, 40, 30, 25, 10, 1}) {
    CAPTURE(angle);
    const Mesh spike = test::make_pyramid(angle, 5);
    const auto generators = on_spike(spike, 0.6);
    const Diagram diagram = compute_diagram(spike, generators);
    REQUIRE(diagram.cells[kTip].neighbours == std::vector<GeneratorId>{kAnnulus});
    const auto ring = TipRings(spike, diagram).find(kAnnulus);
    REQUIRE(ring.size() == 2);
    const ExactField from_tip(spike, {generators[0]});
    for (const SurfacePoint& p : ring) {
      CHECK(from_tip.nearest(p).distance == Approx(from_tip.nearest(generators[1]).distance).epsilon(1e-9));
    }
    const Diagram after = compute_diagram(spike, with(generators, ring));
    CHECK(after.cells[kTip].neighbours.size() == 3);
    for (const Cell& cell : after.cells) CHECK(cell.euler_characteristic == 1);
  }
}

TEST_CASE("tip rings: the points of a flat spike lie apart, also where the generator is on a fold") {
  const Mesh wedge = test::make_pyramid(30, 2);
  const std::vector<SurfacePoint> generators{vertex_point(wedge, VertexId(0)),
                                             edge_point(Mesh::halfedge(FaceId(0), 0), 0.5),
                                             edge_point(Mesh::halfedge(FaceId(0), 1), 0.5)};
  const auto ring = TipRings(wedge, compute_diagram(wedge, generators)).find(kAnnulus);
  REQUIRE(ring.size() == 2);
  const auto apart = [&](const SurfacePoint& a, const SurfacePoint& b) {
    return (position(wedge, a) - position(wedge, b)).norm();
  };
  CHECK(apart(ring[0], ring[1]) > 0.05);
  CHECK(apart(ring[0], generators[1]) > 0.05);
  CHECK(apart(ring[1], generators[1]) > 0.05);
}

TEST_CASE("tip rings: no points for a disc, and for an annulus without a tip") {
  const Mesh spike = test::make_pyramid(30, 5);
  const Diagram diagram = compute_diagram(spike, on_spike(spike, 0.6));
  CHECK(TipRings(spike, diagram).find(kTip).empty());
  const Mesh tube = test::make_ring(24, 6);
  CHECK(TipRings(tube, compute_diagram(tube, {vertex_point(tube, VertexId(0))})).find(kTip).empty());
}

TEST_CASE("tip rings: a tip is narrow where three generators would be closer than their least distance") {
  const Mesh spike = test::make_pyramid(1e-3, 5);
  const double least = 3e-6 * spike.bbox_diagonal() / (1e-3 * std::numbers::pi / 180);
  const auto find = [&](double distance) {
    return TipRings(spike, compute_diagram(spike, on_spike(spike, distance))).find_narrow_tip(kAnnulus);
  };
  const auto narrow = find(0.9 * least);
  REQUIRE(narrow);
  CHECK(narrow->tip == VertexId(0));
  CHECK(narrow->angle == Approx(1e-3 * std::numbers::pi / 180));
  CHECK(narrow->least_distance == Approx(least));
  CHECK_FALSE(find(1.1 * least));
}

}  // namespace gvd::test_tip_rings
