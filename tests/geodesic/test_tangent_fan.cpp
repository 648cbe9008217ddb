#include <numbers>

#include "geodesic/face_layout.hpp"
#include "geodesic/tangent_fan.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_tangent_fan {

constexpr double kPi = std::numbers::pi;

SurfacePoint grid_vertex(const Mesh& mesh, int v) { return vertex_point(mesh, VertexId(v)); }

TEST_CASE("tangent fan: angles are normalized to 0 up to 2 pi") {
  CHECK(normalized_angle(0) == 0);
  CHECK(normalized_angle(2 * kPi) == 0);
  CHECK(normalized_angle(-1e-20) == 0);  // the sum with 2 pi rounds to 2 pi
  CHECK(normalized_angle(-kPi / 2) == Approx(1.5 * kPi));
  CHECK(normalized_angle(9 * kPi) == Approx(kPi));
  CHECK(angle_of(Vec2(0, -1)) == Approx(1.5 * kPi));
}

TEST_CASE("tangent fan: one sector in a face, two on an inner edge, one on a boundary edge") {
  const Mesh grid = test::make_grid(2, 2);
  const TangentFan face(grid, make_surface_point(FaceId(3), {0.2, 0.3, 0.5}));
  CHECK(face.sectors().size() == 1);
  CHECK(face.closed());
  CHECK(face.total() == 2 * kPi);
  for (int h = 0; h < grid.halfedge_count(); ++h) {
    const bool inner = grid.twin(HalfedgeId(h)).valid();
    const TangentFan edge(grid, edge_point(HalfedgeId(h), 0.3));
    CHECK(edge.sectors().size() == (inner ? 2 : 1));
    CHECK(edge.closed() == inner);
    CHECK(edge.total() == (inner ? 2 * kPi : kPi));
  }
}

TEST_CASE("tangent fan: total angles of vertices are scaled to 2 pi, except below it on the boundary") {
  const Mesh grid = test::make_grid(2, 2);
  CHECK(TangentFan(grid, grid_vertex(grid, 4)).closed());
  CHECK(TangentFan(grid, grid_vertex(grid, 0)).total() == Approx(kPi / 2));
  CHECK(TangentFan(grid, grid_vertex(grid, 1)).total() == Approx(kPi));
  const Mesh tetrahedron = test::make_tetrahedron();
  const TangentFan apex(tetrahedron, grid_vertex(tetrahedron, 0));
  CHECK(apex.closed());
  CHECK(apex.total() == 2 * kPi);
  for (const TangentSector& s : apex.sectors()) CHECK(s.width == Approx(2 * kPi / 3));
  // Seven equilateral triangles in a row round a boundary vertex: 420 degrees.
  std::vector<Vec3> positions{{0, 0, 0}};
  std::vector<std::array<int, 3>> faces;
  for (int i = 0; i < 8; ++i) positions.emplace_back(std::cos(i * kPi / 3), std::sin(i * kPi / 3), 0.01 * i);
  for (int i = 1; i < 8; ++i) faces.push_back({0, i, i + 1});
  const Mesh spiral = test::make_mesh(positions, faces);
  const TangentFan crowded(spiral, grid_vertex(spiral, 0));
  CHECK_FALSE(crowded.closed());
  CHECK(crowded.total() == 2 * kPi);
}

TEST_CASE("tangent fan: directions off the surface have no face, but along the boundary within rounding they do") {
  const Mesh grid = test::make_grid(2, 2);
  const TangentFan corner(grid, grid_vertex(grid, 0));
  CHECK_FALSE(corner.face_direction(kPi));
  CHECK(corner.face_direction(-1e-10));
  CHECK(corner.face_direction(corner.total() + 1e-10));
  CHECK_FALSE(corner.face_direction(-1e-8));
  CHECK_FALSE(corner.face_direction(corner.total() + 1e-8));
}

TEST_CASE("tangent fan: an angle's face and direction lead back to the angle, on every family") {
  for (const auto& [name, mesh] : test::small_family()) {
    CAPTURE(name);
    for (const SurfacePoint& p : test::random_generators(mesh, 12, 5)) {
      const TangentFan fan(mesh, p);
      for (int i = 0; i < 16; ++i) {
        const double angle = (i + 0.37) / 16 * fan.total();
        const auto found = fan.face_direction(angle);
        REQUIRE(found);
        CHECK(found->direction.norm() == Approx(1));
        CHECK((position(mesh, found->point) - position(mesh, p)).norm() < 1e-12);
        const double back = fan.angle(found->point.face, found->direction);
        CHECK(std::abs(std::remainder(back - angle, 2 * kPi)) < 1e-9);
      }
    }
  }
}

TEST_CASE("tangent fan: the sectors follow each other counter-clockwise and sum to the total angle") {
  for (const auto& [name, mesh] : test::small_family()) {
    CAPTURE(name);
    for (int v = 0; v < mesh.vertex_count(); v += 7) {
      const TangentFan fan(mesh, vertex_point(mesh, VertexId(v)));
      double end = 0;
      for (const TangentSector& s : fan.sectors()) {
        CHECK(s.begin == Approx(end).margin(1e-12));
        CHECK(s.reference.norm() == Approx(1));
        end = s.begin + s.width;
      }
      CHECK(end == Approx(fan.total()));
    }
  }
}

}  // namespace gvd::test_tangent_fan
