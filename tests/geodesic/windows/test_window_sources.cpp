#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "geodesic/windows/propagation/propagate_windows.hpp"
#include "geodesic/windows/window_sources.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/propagate.hpp"

namespace gvd::test_window_sources {

TEST_CASE("edges are contested where a bisector crosses them, in ascending order") {
  // The bisector of two opposite corners of a square is its other diagonal.
  const Mesh mesh = test::make_grid(9, 9);
  const std::vector<VertexId> generators{VertexId(0), VertexId(mesh.vertex_count() - 1)};
  const WindowField field = test::propagate(mesh, generators, KeepWindows::near_bisectors);
  const WindowDistances distances(mesh, field);
  const Progress silent;
  const std::vector<EdgeId> contested = distances.contested_edges(ParallelChunks(1, silent));
  CHECK(std::is_sorted(contested.begin(), contested.end()));
  for (int i = 0; i < mesh.edge_count(); ++i) {
    const EdgeId e(i);
    const HalfedgeId h = mesh.halfedge(e);
    const bool is_contested = std::binary_search(contested.begin(), contested.end(), e);
    if (field.label[mesh.from(h)] != field.label[mesh.to(h)]) CHECK(is_contested);
    // Far from the bisector nothing is contested.
    const auto side = [&](VertexId v) {
      const auto distance = [&](VertexId g) { return (mesh.position(v) - mesh.position(g)).norm(); };
      return distance(generators[0]) - distance(generators[1]);
    };
    const double from = side(mesh.from(h)), to = side(mesh.to(h));
    if (std::min(std::abs(from), std::abs(to)) > 4 && from * to > 0) CHECK_FALSE(is_contested);
  }
}

TEST_CASE("the sources of an edge are those of the field") {
  const Mesh mesh = test::make_grid(5, 5);
  const WindowField field = test::propagate(mesh, {VertexId(0), VertexId(20)}, KeepWindows::all);
  const WindowDistances distances(mesh, field);
  std::vector<EdgeSource> found, expected;
  for (int i = 0; i < mesh.edge_count(); ++i) {
    distances.collect(EdgeId(i), found);
    collect_edge_sources(mesh, field, mesh.halfedge(EdgeId(i)), expected);
    REQUIRE(found.size() == expected.size());
    for (std::size_t k = 0; k < found.size(); ++k) CHECK(found[k].distance(0.5) == expected[k].distance(0.5));
  }
}

TEST_CASE("the table of exact distances has each vertex's nearest generator, and no distance that is too short") {
  const Mesh mesh = test::make_bumpy_sphere(3, 2);
  const std::vector<VertexId> generators{VertexId(0), VertexId(100), VertexId(200)};
  const WindowField field = test::propagate(mesh, generators, KeepWindows::near_bisectors);
  const GeneratorTable table = make_generator_table(mesh, field);
  std::vector<WindowField> alone;
  for (const VertexId g : generators) alone.push_back(test::propagate(mesh, {g}));
  for (int i = 0; i < mesh.vertex_count(); ++i) {
    const VertexId v(i);
    const std::int32_t nearest = table.find(v, field.label[v]);
    REQUIRE(nearest >= 0);
    CHECK(table.distance(nearest).distance == Approx(field.distance[v]).epsilon(1e-12).margin(1e-14));
    table.for_each(
        v, [&](const VertexDistance& d) { CHECK(d.distance >= alone[d.generator.index()].distance[v] * (1 - 1e-12)); });
  }
  for (int f = 0; f < mesh.face_count(); ++f) CHECK(table.reached(FaceId(f)));
}

}  // namespace gvd::test_window_sources
