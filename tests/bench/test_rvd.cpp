#include <algorithm>

#include "bench/comparisons.hpp"
#include "bench/flat_grid.hpp"
#include "bench/pieces_of_faces.hpp"
#include "comparators.hpp"
#include "judge.hpp"
#include "pieces.hpp"
#include "rvd.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

namespace gvd::test_rvd {

using namespace paper;

TEST_CASE("on a flat grid RVD is the planar Voronoi diagram") {
  const test::FlatGrid flat;
  const Comparison rvd = compute_rvd(flat.mesh, flat.generators);
  flat.check(rvd, 1e-9);
  CHECK(Judge(flat.mesh, flat.generators).judge(rvd.diagram).wrong_labels == 0);
  const Diagram exact = compute_diagram(flat.mesh, flat.generators);
  CHECK(rvd.diagram.length == Approx(exact.length).epsilon(1e-6));
}

TEST_CASE("the pieces of RVD cover every mesh") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    const auto generators = test::random_generators(mesh, 20, 5);
    const auto positions = find_positions(mesh, generators);
    const Pieces pieces = clip_to_voronoi_cells(mesh, positions, find_delaunay_neighbours(positions));
    CHECK(test::sum_areas(mesh, pieces) == Approx(test::mesh_area(mesh)).epsilon(1e-9));
    CHECK(compute_rvd(mesh, generators).faults.open_ends == 0);
  }
}

TEST_CASE("Delaunay neighbours give the same cells as all generators") {
  const Mesh mesh = test::make_torus(24, 12);
  const auto generators = test::random_generators(mesh, 25, 7);
  const auto positions = find_positions(mesh, generators);
  std::vector<std::vector<GeneratorId>> all(positions.size());
  for (auto& list : all) {
    for (int g = 0; g < 25; ++g) list.emplace_back(g);
  }
  Comparison few, many;
  collect_pieces(mesh, generators, clip_to_voronoi_cells(mesh, positions, find_delaunay_neighbours(positions)), few);
  collect_pieces(mesh, generators, clip_to_voronoi_cells(mesh, positions, all), many);
  for (int g = 0; g < 25; ++g) {
    CHECK(few.diagram.cells[GeneratorId(g)].area == Approx(many.diagram.cells[GeneratorId(g)].area).epsilon(1e-9));
  }
}

TEST_CASE("cells of mirrored generators are found too, and one or two generators need no triangulation") {
  const Mesh mesh = test::make_sphere(2);  // cospherical: the triangulation is not unique
  std::vector<SurfacePoint> generators;
  for (int v = 0; v < 12; ++v) generators.push_back(vertex_point(mesh, VertexId(v)));
  const Comparison twelve = compute_rvd(mesh, generators);
  for (const Cell& cell : twelve.diagram.cells) CHECK(cell.area == Approx(test::mesh_area(mesh) / 12).epsilon(1e-9));
  generators.resize(2);
  CHECK(compute_rvd(mesh, generators).diagram.cells[GeneratorId(1)].area ==
        Approx(test::mesh_area(mesh) / 2).epsilon(1e-9));
  generators.resize(1);
  CHECK(compute_rvd(mesh, generators).diagram.bisectors.empty());
}

TEST_CASE("on a thin plate cells of RVD come through to the other side") {
  const Mesh mesh = test::make_plate(16, 0.01);
  const auto generators = test::random_generators(mesh, 12, 1);
  const Comparison rvd = compute_rvd(mesh, generators);
  CHECK(rvd.faults.islands > 0);
  CHECK(rvd.faults.island_area > 0.1);
  const Judge judge(mesh, generators);
  const Diagram exact = compute_diagram(mesh, generators);
  CHECK(judge.judge(rvd.diagram).error.error_integral > 100 * judge.judge(exact).error.error_integral);
  CHECK(judge.judge(rvd.diagram).wrong_labels > 0);
  CHECK(judge.judge(exact).wrong_labels == 0);
}

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
  const Comparison same = compute_lrvd(plate, generators, 0);
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

TEST_CASE("where islands touch, LRVD leaves borders that are no bisectors of their cells") {
  const Mesh mesh = test::make_plate(16, 0.01);
  double most = 0;
  for (unsigned seed = 0; seed < 10; ++seed) {
    const auto generators = test::random_generators(mesh, 30, seed);
    const OtherJudge judge(mesh, generators);
    CHECK(judge.judge(compute_rvd(mesh, generators).diagram).by_straight < 1e-12);
    most = std::max(most, judge.judge(compute_lrvd(mesh, generators).diagram).by_straight);
  }
  CHECK(most > 0.01);
}

TEST_CASE("an island on a component without a generator stays, and is counted") {
  const Mesh mesh = test::make_two_components();
  const Comparison lrvd = compute_lrvd(mesh, {vertex_point(mesh, VertexId(0)), vertex_point(mesh, VertexId(1))});
  CHECK(lrvd.faults.islands > 0);
  CHECK(lrvd.rounds == 0);
}

}  // namespace gvd::test_rvd
