#include "bench/comparisons.hpp"
#include "judging/judge.hpp"
#include "rvd/lrvd.hpp"
#include "rvd/rvd.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

namespace gvd::test_lrvd {

using namespace paper;

TEST_CASE("LRVD leaves no island on a thin plate, where RVD does") {
  const Mesh mesh = test::make_plate(16, 0.01);
  int with_islands = 0;
  for (unsigned seed = 0; seed < 10; ++seed) {
    INFO(seed);
    const auto generators = test::random_generators(mesh, 12, seed);
    const Comparison rvd = compute_rvd(mesh, generators), lrvd = compute_lrvd(mesh, generators);
    with_islands += rvd.faults.islands > 0 ? 1 : 0;
    CHECK((rvd.faults.islands > 0) == (lrvd.rounds > 0));
    CHECK(lrvd.faults.islands == 0);
    CHECK(lrvd.faults.lost_generators == 0);
    CHECK(lrvd.faults.open_ends == 0);
    CHECK(lrvd.rounds < 10);
    for (const Cell& cell : lrvd.diagram.cells) CHECK(cell.components == 1);
    CHECK(test::total_area(lrvd.diagram) == Approx(test::mesh_area(mesh)).epsilon(1e-9));
  }
  CHECK(with_islands > 5);
}

TEST_CASE("LRVD of every mesh is connected and covers it") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    const Comparison lrvd = compute_lrvd(mesh, test::random_generators(mesh, 20, 5));
    CHECK(lrvd.faults.islands == 0);
    CHECK(lrvd.faults.open_ends == 0);
    CHECK(test::total_area(lrvd.diagram) == Approx(test::mesh_area(mesh)).epsilon(1e-9));
  }
}

TEST_CASE("without sweeps LRVD is RVD, and without islands it needs none") {
  const Mesh plate = test::make_plate(16, 0.01);
  const auto generators = test::random_generators(plate, 12, 1);
  const Comparison rvd = compute_rvd(plate, generators);
  const Comparison same = compute_lrvd(plate, generators, {0});
  CHECK(same.rounds == 0);
  CHECK(same.faults.islands == rvd.faults.islands);
  CHECK(same.diagram.length == rvd.diagram.length);
  const Mesh grid = test::make_grid(8, 8);
  CHECK(compute_lrvd(grid, test::random_generators(grid, 9, 2)).rounds == 0);
}

TEST_CASE("the cells of LRVD are still not the geodesic ones") {
  const Mesh mesh = test::make_plate(16, 0.01);
  const auto generators = test::random_generators(mesh, 12, 1);
  const Judge judge(mesh, generators);
  const Judgement rvd = judge.judge(compute_rvd(mesh, generators).diagram);
  const Judgement lrvd = judge.judge(compute_lrvd(mesh, generators).diagram);
  CHECK(lrvd.wrong_labels > 0);
  CHECK(lrvd.wrong_labels < rvd.wrong_labels);
  CHECK(lrvd.error.error_integral < rvd.error.error_integral);
}

TEST_CASE("an island on a component without a generator stays, and is counted") {
  const Mesh mesh = test::make_two_components();
  const Comparison lrvd = compute_lrvd(mesh, {vertex_point(mesh, VertexId(0)), vertex_point(mesh, VertexId(1))});
  CHECK(lrvd.faults.islands > 0);
  CHECK(lrvd.rounds == 0);
}

}  // namespace gvd::test_lrvd
