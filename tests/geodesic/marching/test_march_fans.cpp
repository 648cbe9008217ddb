#include "geodesic/marching/march_fans.hpp"
#include "mesh/vertex_ring.hpp"
#include "support/cancelled.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_march_fans {

/// The same faces with other positions.
template <class Place>
Mesh moved(const Mesh& mesh, Place place) {
  std::vector<Vec3> positions;
  for (const Vec3& p : mesh.positions()) positions.push_back(place(p));
  return Mesh(std::move(positions), mesh.face_vertices());
}

void check_places(const Mesh& mesh) {
  const MarchFans fans(mesh);
  std::vector<char> seen(static_cast<std::size_t>(mesh.vertex_count()), 0);
  for (const VertexId v : mesh.vertices()) {
    const PlaceId p = fans.place(v);
    REQUIRE(fans.vertex(p) == v);
    REQUIRE(seen[p.index()]++ == 0);
  }
}

TEST_CASE("a place belongs to one vertex, also where extents overflow or underflow") {
  check_places(test::make_triangle());
  const Mesh grid = test::make_grid(40, 3);
  check_places(grid);
  check_places(moved(grid, [](const Vec3& p) { return Vec3(p * 0x1p-1060); }));
  check_places(moved(grid, [](const Vec3& p) { return Vec3((p - Vec3(20, 0, 0)) * 0x1.8p1018); }));
}

TEST_CASE("the spokes of a vertex are its edges and faces in the order of its ring") {
  for (const auto& named : test::small_family()) {
    const Mesh& mesh = named.mesh;  // clang 14 captures no structured binding
    INFO(named.name);
    const MarchFans fans(mesh);
    for (const VertexId v : mesh.vertices()) {
      const auto spokes = fans.spokes(fans.place(v));
      std::size_t i = 0;
      HalfedgeId last;
      for_each_outgoing(mesh, v, [&](HalfedgeId h) {
        REQUIRE(i < spokes.size());
        REQUIRE(spokes[i].has_face());
        REQUIRE(fans.vertex(spokes[i].end) == mesh.to(h));
        REQUIRE(spokes[i].length == mesh.length(h));
        REQUIRE(spokes[i].rim == mesh.length(Mesh::next(h)));
        REQUIRE(spokes[i].twice_area == mesh.shape(Mesh::face(h)).twice_area);
        last = Mesh::previous(h);
        ++i;
      });
      REQUIRE(spokes.size() == (mesh.is_boundary(v) ? i + 1 : i));
      if (!mesh.is_boundary(v)) continue;
      CHECK_FALSE(spokes[i].has_face());
      CHECK(fans.vertex(spokes[i].end) == mesh.from(last));
      CHECK(spokes[i].length == mesh.length(last));
    }
  }
}

TEST_CASE("the copy of a large mesh can be cancelled between its vertices") {
  const Mesh grid = test::make_grid(300, 300);
  const auto calls = test::require_cancelled_everywhere([&](const Progress& progress) { MarchFans(grid, progress); });
  CHECK(calls.at("sampling") >= 5);
}

TEST_CASE("vertices that are near each other have near places, whatever their ids are") {
  // Ids of a grid row by row: a vertex and the one above it lie 256 ids apart.
  const Mesh grid = test::make_grid(255, 255);
  const MarchFans fans(grid);
  std::int32_t near = 0;
  for (const EdgeId e : grid.edges()) {
    const HalfedgeId h = grid.halfedge(e);
    near += std::abs(fans.place(grid.from(h)).value() - fans.place(grid.to(h)).value()) < 32 ? 1 : 0;
  }
  CHECK(near > 0.75 * grid.edge_count());
}

}  // namespace gvd::test_march_fans
