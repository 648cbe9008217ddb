#include <cmath>
#include <vector>

#include "geodesic/marching/local_march.hpp"
#include "geodesic/sampling/nearest_field.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/samples.hpp"

namespace gvd::test_nearest_field {

using test::kInfinity;
using test::sample;

TEST_CASE("nearest field: before the first generator, and in a component without one") {
  const Mesh mesh = test::make_two_components();
  NearestField field(mesh, Front::circle);
  CHECK(std::isinf(field.distance(VertexId(0))));
  CHECK_FALSE(field.label(VertexId(0)).valid());
  CHECK(field.insert(vertex_point(mesh, VertexId(0))) == GeneratorId(0));
  CHECK(field.distance(VertexId(0)) == 0);
  const VertexId beyond(mesh.vertex_count() - 1);
  CHECK(std::isinf(field.distance(beyond)));
  CHECK_FALSE(field.label(beyond).valid());
}

TEST_CASE("nearest field: of two coincident generators the earlier one is kept") {
  const Mesh grid = test::make_grid(3, 3);
  NearestField field(grid, Front::circle);
  for (int i = 0; i < 2; ++i) field.insert(vertex_point(grid, VertexId(5)));
  for (int v = 0; v < grid.vertex_count(); ++v) CHECK(field.label(VertexId(v)) == GeneratorId(0));
}

TEST_CASE("nearest field: on a flat grid every vertex has the label of the nearest generator") {
  const Mesh grid = test::make_grid(8, 8);
  const auto points = sample(grid, Sampling::random, 6, 4);
  NearestField field(grid, Front::circle);
  for (const SurfacePoint& p : points) field.insert(p);
  for (int v = 0; v < grid.vertex_count(); ++v) {
    double nearest = kInfinity;
    for (const SurfacePoint& p : points) {
      nearest = std::min(nearest, (position(grid, p) - grid.position(VertexId(v))).norm());
    }
    const SurfacePoint& own = points[field.label(VertexId(v)).index()];
    CHECK((position(grid, own) - grid.position(VertexId(v))).norm() == Approx(nearest).epsilon(0.02));
    CHECK(field.distance(VertexId(v)) == Approx(nearest).epsilon(0.02));
  }
}

TEST_CASE("nearest field: insertion gives the distances of the nearest generator by itself") {
  for (const auto& [name, mesh] : test::small_family()) {
    const auto points = sample(mesh, Sampling::random, 30, 2);
    NearestField field(mesh, Front::circle);
    LocalMarch march(mesh, Front::circle);
    std::vector<double> nearest(static_cast<std::size_t>(mesh.vertex_count()), kInfinity);
    for (const SurfacePoint& p : points) {
      field.insert(p);
      march.run(p, kInfinity);
      for (int v = 0; v < mesh.vertex_count(); ++v) {
        nearest[v] = std::min(nearest[v], march.distance(VertexId(v)));
      }
    }
    for (int v = 0; v < mesh.vertex_count(); ++v) {
      INFO(name << ", vertex " << v);
      // Never nearer than alone. A front stops one ring beyond its cell, so distances near the border can be a little
      // too long. Among thin faces a straight path passes close to vertices of other cells: up to a quarter too long.
      const double loss = name == "thin-faced sphere" ? 0.25 : 0.05;
      const double whole = nearest[v], inserted = field.distance(VertexId(v));
      CHECK(inserted >= whole * (1 - 1e-12));
      CHECK(inserted <= whole * (1 + loss) + 0.05 * mesh.mean_edge_length());
    }
  }
}

}  // namespace gvd::test_nearest_field
