#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "geodesic/windows/propagation/propagate_windows.hpp"
#include "geodesic/windows/window_sources.hpp"
#include "gvd/generator_curve.hpp"
#include "mesh/working_mesh.hpp"
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

TEST_CASE(
    "the sources of a face beside a curve are windows, corners and parallel paths, each with its image or direction") {
  const Mesh mesh = test::make_grid(6, 6);
  const HalfedgeId segment = Mesh::halfedge(FaceId(mesh.face_count() / 2), 0);
  const GeneratorCurve curve = make_polyline({edge_point(segment, 0), edge_point(Mesh::next(segment), 0)}, false);
  const WorkingMesh working(mesh, std::vector{curve});
  const WindowField field = propagate_windows(working, {}, {});
  std::vector<FaceSource> sources;
  int windows = 0, corners = 0, parallel = 0;
  for (const FaceId f : mesh.faces()) {
    collect_face_sources(mesh, field, f, sources);
    for (const FaceSource& s : sources) {
      const Vec2 middle = 0.5 * (s.begin + s.end);
      if (s.kind == FaceSource::Kind::corner) {
        ++corners;
        CHECK(s.begin == s.image);
        CHECK(s.end == s.image);
      } else if (s.kind == FaceSource::Kind::parallel) {
        ++parallel;
        CHECK(s.direction().norm() == Approx(1));
        CHECK(s.distance(middle) == Approx(0.5 * (s.distance_begin + s.distance_end)).margin(1e-12));
      } else {
        ++windows;
        CHECK(s.distance(middle) >= Approx(s.offset + (middle - s.image).norm()));
      }
    }
  }
  CHECK(corners == 3 * mesh.face_count());
  CHECK(windows > 0);
  CHECK(parallel > 0);
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
