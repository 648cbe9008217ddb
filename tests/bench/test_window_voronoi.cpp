#include "bench/flat_grid.hpp"
#include "comparators.hpp"
#include "judge.hpp"
#include "support/catch.hpp"

namespace gvd::test_window_voronoi {

using namespace paper;

TEST_CASE("on a flat grid exact windows give the planar Voronoi diagram, wherever the generators lie") {
  const test::FlatGrid flat;
  const Comparison found = compute_window_voronoi(flat.mesh, flat.generators);
  flat.check(found, 1e-6);
  CHECK(found.faults.forced_faces == 0);
}

TEST_CASE("on a sphere straight segments between exact crossings beat planar growth") {
  const Mesh mesh = test::make_sphere(3);
  const auto generators = test::vertex_points(mesh, 14, 0, (mesh.vertex_count() - 1) / 13);
  const Judge judge(mesh, generators);
  DiagramOptions planar;
  planar.method = Method::gbgvd;
  planar.front = Front::planar;
  const Comparison found = compute_window_voronoi(mesh, generators);
  const Judgement judgement = judge.judge(found.diagram);
  CHECK(judgement.error.error_integral > 0);
  CHECK(judgement.error.error_integral < 0.1 * test::error_of(judge, compute_diagram(mesh, generators, planar)));
  CHECK(judgement.wrong_labels == 0);
  const Diagram exact = compute_diagram(mesh, generators);
  CHECK(judgement.error.error_integral > test::error_of(judge, exact));  // whose arcs are curved
  CHECK(found.diagram.length == Approx(exact.length).epsilon(1e-3));
}

TEST_CASE("windows that no other generator prunes give the same diagram") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    const auto generators = test::vertex_points(mesh, 9, 0, (mesh.vertex_count() - 1) / 8);
    const Comparison pruned = compute_window_voronoi(mesh, generators);
    const Comparison unpruned = compute_window_voronoi(mesh, generators, {true});
    const Judge judge(mesh, generators);
    CHECK(judge.judge(pruned.diagram).wrong_labels == 0);
    CHECK(judge.judge(unpruned.diagram).wrong_labels == 0);
    CHECK(unpruned.diagram.length == Approx(pruned.diagram.length).epsilon(0.02));
    CHECK(test::error_of(judge, unpruned.diagram) <=
          1.5 * test::error_of(judge, pruned.diagram) + 1e-6 * mesh.bbox_diagonal());
  }
}

TEST_CASE("exact windows leave no island and no open end on curved meshes") {
  for (const Mesh& mesh : {test::make_bumpy_sphere(3, 4), test::make_torus(24, 12), test::make_plate(12, 0.01)}) {
    const Comparison found = compute_window_voronoi(mesh, test::random_generators(mesh, 12, 6));
    CHECK(found.faults.islands == 0);
    CHECK(found.faults.lost_generators == 0);
    CHECK(found.faults.open_ends == 0);
    double area = 0;
    for (const Cell& cell : found.diagram.cells) area += cell.area;
    CHECK(area == Approx(compute_mesh_summary(mesh).area).epsilon(1e-9));
  }
}

TEST_CASE(
    "cells that come into a face twice stay connected: each branch point serves the runs its paths come through") {
  const std::vector<std::pair<Mesh, unsigned>> cases{
      {test::make_genus3(2), 6}, {test::make_torus(16, 8), 7}, {test::make_bumpy_sphere(2, 1), 7}};
  for (const auto& [mesh, seed] : cases) {
    INFO(mesh.face_count());
    CHECK(compute_window_voronoi(mesh, test::random_generators(mesh, 12, seed)).faults.islands == 0);
  }
}

TEST_CASE("a bisector along edges and through vertices is one polyline, up to the boundary") {
  const Mesh mesh = test::make_grid(8, 4);
  const auto vertex_at = [&](int x, int y) { return vertex_point(mesh, VertexId(y * 9 + x)); };
  const Comparison along = compute_window_voronoi(mesh, {vertex_at(2, 2), vertex_at(6, 2)});
  CHECK(along.faults.open_ends == 0);
  REQUIRE(along.diagram.bisectors.size() == 1);
  CHECK(along.diagram.length == Approx(4));
  const Comparison across = compute_window_voronoi(mesh, {vertex_at(2, 1), vertex_at(1, 2), vertex_at(6, 3)});
  CHECK(across.faults.open_ends == 0);
  CHECK(across.diagram.bisectors.size() == 3);
}

TEST_CASE("unpruned windows cross an edge at its end too, where two generators tie up to rounding") {
  const Mesh unit = test::make_grid(8, 4);  // the bisector runs through vertices, and a generator is a step away
  std::vector<std::array<VertexId, 3>> faces;
  for (int f = 0; f < unit.face_count(); ++f) faces.push_back(unit.vertices(FaceId(f)));
  std::vector<Vec3> positions = unit.positions();
  for (Vec3& p : positions) p.x() += p.x() == 5 ? 4e-15 : 0;
  const Mesh mesh(positions, faces);
  const auto vertex_at = [&](int x, int y) { return vertex_point(mesh, VertexId(y * 9 + x)); };
  const Comparison found = compute_window_voronoi(mesh, {vertex_at(5, 2), vertex_at(3, 2)}, {true});
  CHECK(found.diagram.length == Approx(4));
  CHECK(found.diagram.cells[GeneratorId(0)].area == Approx(16));
}

}  // namespace gvd::test_window_voronoi
