#include <algorithm>

#include "diagram/graph/cell_components.hpp"
#include "diagram/growth/assemble_faces.hpp"
#include "gvd/diagram.hpp"
#include "support/catch.hpp"
#include "support/edge_between.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/stages.hpp"

namespace gvd::test_cell_components {

struct Expected {
  std::int32_t euler_characteristic, loops;
};

void require_cells(const Mesh& mesh, const std::vector<int>& generators, const std::vector<Expected>& expected) {
  const Diagram diagram = compute_diagram(mesh, test::at_vertices(mesh, generators));
  REQUIRE(diagram.cells.size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    INFO("cell " << i);
    const Cell& cell = diagram.cells[GeneratorId(i)];
    CHECK(cell.generator.index() == i);
    CHECK(cell.components == 1);
    CHECK(cell.euler_characteristic == expected[i].euler_characteristic);
    CHECK(cell.boundary_loops == expected[i].loops);
  }
}

/// One generator on a flat grid, with intervals of cells written in by hand and the faces assembled.
struct HandMade {
  Mesh mesh = test::make_grid(6, 6);
  test::Stages stages{mesh, test::at_vertices(mesh, {0, 48}), Front::circle};
  TracedDiagram traced{stages.labels, stages.rough};

  EdgeId edge(int u, int v) const { return test::edge_between(mesh, u, v); }

  /// An interval of generator `inner` in the middle of an edge that belongs to `outer`.
  void poke(EdgeId e, GeneratorId outer, GeneratorId inner) {
    auto items = traced.crossings.items();
    items.push_back({e, 0.4, outer, inner});
    items.push_back({e, 0.6, inner, outer});
    std::stable_sort(items.begin(), items.end(), [](const Crossing& a, const Crossing& b) { return a.edge < b.edge; });
    traced.crossings = Crossings(mesh.edge_count(), items);
  }

  CellComponents components() {
    traced.faces = {};
    assemble_faces({stages.working, stages.table(), traced.labels, Front::circle}, traced.crossings, {}, traced.faces);
    return find_cell_components(stages.working, traced);
  }
};

TEST_CASE("known cells: the whole sphere, two discs, a torus, an annulus, a genus 3 body with and without a hole") {
  require_cells(test::make_sphere(2), {0}, {{2, 0}});
  require_cells(test::make_sphere(2), {0, 3}, {{1, 1}, {1, 1}});
  require_cells(test::make_torus(24, 12), {0}, {{0, 0}});
  require_cells(test::make_grid(6, 6), {0}, {{1, 1}});
  require_cells(test::make_ring(24, 6), {10}, {{0, 2}});
  require_cells(test::make_ring(24, 6), {3, 12 * 7 + 3}, {{1, 1}, {1, 1}});
  require_cells(test::make_genus3(3), {0}, {{-4, 0}});
}

TEST_CASE("two generators across a torus own an annulus each") {
  // Opposite round the large circle: two closed bisectors.
  const Mesh mesh = test::make_torus(24, 12);
  require_cells(mesh, {0, 12 * 12}, {{0, 2}, {0, 2}});
}

TEST_CASE("cells without a generator in their component are not counted") {
  const Mesh mesh = test::make_two_components();
  require_cells(mesh, {0}, {{2, 0}});
  require_cells(mesh, {0, mesh.vertex_count() - 1}, {{2, 0}, {0, 0}});
}

TEST_CASE("traced diagrams have no island, on every family") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    const WorkingMesh working(mesh, test::random_generators(mesh, 60, 14));
    const FastMarchingResult marched = march(working, Front::circle, {});
    const TracedDiagram traced = test::trace_growth(working, marched.table, Front::circle);
    const CellComponents components = find_cell_components(working, traced);
    REQUIRE(components.island_edges.empty());
    REQUIRE(components.island_vertices.empty());
    for (const std::int32_t count : components.count) REQUIRE(count == 1);
  }
}

TEST_CASE("a disconnected interval is an island of its cell, and the edges of its faces are named") {
  HandMade made;
  {
    const CellComponents components = made.components();
    CHECK(components.count.raw() == std::vector<std::int32_t>{1, 1});
    CHECK(components.island_edges.empty());
  }
  const EdgeId e = made.edge(1, 2);  // on the boundary, near generator 0
  const EdgeId f = made.edge(1, 8);  // inside
  for (const EdgeId poked : {e, f}) {
    HandMade fresh;
    fresh.poke(poked, GeneratorId(0), GeneratorId(1));
    const CellComponents components = fresh.components();
    CHECK(components.count.raw() == std::vector<std::int32_t>{1, 2});
    const auto islands = components.island_edges;
    CHECK(std::is_sorted(islands.begin(), islands.end()));
    CHECK(std::binary_search(islands.begin(), islands.end(), poked));
    CHECK(islands.size() == (poked == e ? 3 : 5));
    CHECK(components.island_vertices.empty());
  }
}

TEST_CASE("a vertex of another cell in the middle of a cell is an island") {
  HandMade made;
  const VertexId v(8);  // next to generator 0, inside
  made.traced.labels.label[v] = GeneratorId(1);
  made.traced.moved.push_back(v);
  auto items = made.traced.crossings.items();
  for (int i = 0; i < made.mesh.edge_count(); ++i) {
    const HalfedgeId h = made.mesh.halfedge(EdgeId(i));
    if (made.mesh.from(h) == v) items.push_back({EdgeId(i), 0.5, GeneratorId(1), GeneratorId(0)});
    if (made.mesh.to(h) == v) items.push_back({EdgeId(i), 0.5, GeneratorId(0), GeneratorId(1)});
  }
  std::stable_sort(items.begin(), items.end(), [](const Crossing& a, const Crossing& b) { return a.edge < b.edge; });
  made.traced.crossings = Crossings(made.mesh.edge_count(), items);
  const CellComponents components = made.components();
  CHECK(components.count.raw() == std::vector<std::int32_t>{1, 2});
  CHECK(components.island_vertices == std::vector<VertexId>{v});
}

TEST_CASE("loops of bisectors and of the mesh's boundary agree with the Euler characteristics") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    for (const int count : {1, 2, 20}) {
      const Diagram diagram = compute_diagram(mesh, test::random_generators(mesh, count, 15));
      for (const Cell& cell : diagram.cells) {
        const int twice_genus = 2 - cell.boundary_loops - cell.euler_characteristic;
        REQUIRE(twice_genus >= 0);
        REQUIRE(twice_genus % 2 == 0);
        if (count > 1 && name != "two components") REQUIRE(cell.boundary_loops >= 1);
      }
    }
  }
}

}  // namespace gvd::test_cell_components
