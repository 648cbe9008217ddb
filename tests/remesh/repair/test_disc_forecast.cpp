// Forecasts of discs: what the labels of vertices foretell is what a diagram then has.
#include <utility>
#include <vector>

#include "gvd/disc_cells.hpp"
#include "repair/disc_forecast.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

namespace gvd::test_disc_forecast {

int count_all(const Diagram& diagram) {
  int all = 0;
  for (const Cell& cell : diagram.cells) all += count_disc_defects(cell);
  return all;
}

TEST_CASE("disc forecast: where it foretells fewer defects, a diagram mostly has fewer") {
  int foretold = 0, right = 0;
  for (const auto& [mesh, seed] : {std::pair(test::make_torus(96, 48), 1U), {test::make_genus3(12), 2U}}) {
    DiscForecast forecast(mesh);
    const auto generators = test::random_generators(mesh, 4, seed);
    const Diagram diagram = compute_diagram(mesh, generators);
    forecast.take(diagram);
    const GeneratorId divided = find_non_discs(diagram).at(0);
    CHECK(forecast.tells(divided));
    for (std::int32_t v = 5; v < mesh.vertex_count(); v += 61) {
      const SurfacePoint point = vertex_point(mesh, VertexId(v));
      if (forecast.find(point, divided).defects >= 0) continue;
      auto more = generators;
      more.push_back(point);
      right += count_all(compute_diagram(mesh, more)) < count_all(diagram);
      ++foretold;
    }
  }
  CHECK(foretold > 10);
  CHECK(right >= 0.8 * foretold);
}

TEST_CASE("disc forecast: the better of two outcomes has fewer defects, then smaller ones, then an even division") {
  using Outcome = DiscForecast::Outcome;
  CHECK(Outcome{-1, 5, 9} < Outcome{0, -5, 0});
  CHECK(Outcome{0, -2, 9} < Outcome{0, 0, 0});
  CHECK(Outcome{0, 0, 3} < Outcome{0, 0, 4});
  CHECK(Outcome{1000, 1000, 1000} < DiscForecast::kWorst);
}

TEST_CASE("disc forecast: a point on the other side of a tube divides the cell round it") {
  const Mesh ring = test::make_ring(48, 12);
  const std::vector<SurfacePoint> one{vertex_point(ring, VertexId(0))};
  const Diagram diagram = compute_diagram(ring, one);
  REQUIRE(diagram.cells[GeneratorId(0)].euler_characteristic == 0);
  DiscForecast forecast(ring);
  forecast.take(diagram);
  const Vec3& at = ring.position(VertexId(0));
  const auto outcome_at = [&](const Vec3& place) {
    VertexId nearest(0);
    for (const VertexId v : ring.vertices()) {
      if ((ring.position(v) - place).norm() < (ring.position(nearest) - place).norm()) nearest = v;
    }
    return forecast.find(vertex_point(ring, nearest), GeneratorId(0));
  };
  const DiscForecast::Outcome opposite = outcome_at({-at.x(), -at.y(), at.z()});
  CHECK(opposite.defects == -1);
  CHECK(opposite.squares == -1);
  CHECK(opposite.imbalance <= 0.1 * ring.vertex_count());
}

}  // namespace gvd::test_disc_forecast
