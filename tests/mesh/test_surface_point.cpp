#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>

#include "gvd/surface_point.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_surface_point {

TEST_CASE("the faces around a point are those that contain all corners it depends on, on every family") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    for (const SurfacePoint& p : test::random_generators(mesh, 60, 5)) {
      std::vector<FaceId> expected;
      for (int f = 0; f < mesh.face_count(); ++f) {
        const auto& corners = mesh.vertices(FaceId(f));
        // The corners that the point depends on all belong to the face.
        bool named = true;
        for (std::size_t i = 0; i < 3; ++i) {
          const VertexId v = mesh.vertices(p.face)[i];
          named = named && (p.bary[i] == 0 || std::count(corners.begin(), corners.end(), v) > 0);
        }
        if (named) expected.push_back(FaceId(f));
      }
      std::vector<FaceId> found = faces_around(mesh, p);
      std::sort(found.begin(), found.end());
      REQUIRE(found == expected);
    }
  }
}

TEST_CASE("a point is on the boundary where its vertex or its edge is, and never inside a face") {
  const Mesh grid = test::make_grid(3, 3);
  const auto vertex = [&](int i, int j) { return vertex_point(grid, VertexId(j * 4 + i)); };
  CHECK(is_on_boundary(grid, vertex(0, 0)));
  CHECK(is_on_boundary(grid, vertex(2, 0)));
  CHECK_FALSE(is_on_boundary(grid, vertex(1, 2)));
  for (int e = 0; e < grid.edge_count(); ++e) {
    const HalfedgeId h = grid.halfedge(EdgeId(e));
    const Vec3 p = position(grid, edge_point(h, 0.5));
    const bool is_outer = p.x() == 0 || p.x() == 3 || p.y() == 0 || p.y() == 3;
    CHECK(is_on_boundary(grid, edge_point(h, 0.5)) == is_outer);
  }
  CHECK_FALSE(is_on_boundary(grid, make_surface_point(FaceId(0), {0.2, 0.3, 0.5})));
}

TEST_CASE("a value at a point is linear between its face's vertices, of which it leaves out those without weight") {
  const Mesh mesh = test::make_grid(1, 1);
  IdVector<VertexId, double> values(4, std::numeric_limits<double>::infinity());
  const auto& [a, b, c] = mesh.vertices(FaceId(0));
  values[a] = 1;
  values[b] = 3;
  CHECK(interpolate_at(mesh, values, make_surface_point(FaceId(0), {0.25, 0.75, 0})) == 2.5);
  CHECK(std::isinf(interpolate_at(mesh, values, make_surface_point(FaceId(0), {0.25, 0.5, 0.25}))));
  values[c] = 7;
  CHECK(interpolate_at(mesh, values, make_surface_point(FaceId(0), {0.25, 0.5, 0.25})) == 3.5);
}

TEST_CASE("coincidence is a part of the bounding box near the origin, and follows the scale") {
  const Mesh mesh = test::make_tetrahedron();
  CHECK(coincidence(mesh) == kCoincidence * mesh.bbox_diagonal());
  CHECK(coincidence(test::scaled(mesh, 1e6)) == Approx(1e6 * coincidence(mesh)));
}

TEST_CASE("far from the origin coincidence is the rounding of the coordinates") {
  const auto shifted = [](double x) { return test::make_mesh({{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}}, {{0, 1, 2}}); };
  CHECK(coincidence(shifted(1e6)) == kCoordinateRounding * (1e6 + 1));
  CHECK(coincidence(shifted(-1e6)) == kCoordinateRounding * 1e6);
  CHECK(coincidence(shifted(1)) == kCoincidence * shifted(1).bbox_diagonal());
}

TEST_CASE("views: one in each face that contains the point, ascending, all at the point's position") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    for (const SurfacePoint& p : test::random_generators(mesh, 60, 8)) {
      const std::vector<SurfacePoint> views = find_views(mesh, p);
      std::vector<FaceId> faces = faces_around(mesh, p);
      std::sort(faces.begin(), faces.end());
      REQUIRE(views.size() == faces.size());
      for (std::size_t i = 0; i < views.size(); ++i) {
        REQUIRE(views[i].face == faces[i]);
        REQUIRE(views[i].kind() == p.kind());
        REQUIRE((position(mesh, views[i]) - position(mesh, p)).norm() <= 1e-14 * mesh.bbox_diagonal());
        REQUIRE(canonical(mesh, views[i]) == canonical(mesh, p));
      }
      REQUIRE(canonical(mesh, p) == views.front());
    }
  }
}

TEST_CASE("views: the point across an edge has the same weights, and comes back") {
  const Mesh mesh = test::make_grid(2, 2);
  for (int i = 0; i < mesh.halfedge_count(); ++i) {
    const HalfedgeId h(i);
    const SurfacePoint p = edge_point(h, 0.375);
    const auto across = find_view_across(mesh, p);
    REQUIRE(across.has_value() == mesh.twin(h).valid());
    if (!across) continue;
    CHECK(halfedge(*across) == mesh.twin(h));
    CHECK(*across == edge_point(mesh.twin(h), 0.625));
    CHECK(*find_view_across(mesh, *across) == p);
  }
}

TEST_CASE("views: two points have a common one exactly where a face contains both, and it is the first") {
  const Mesh mesh = test::make_torus(8, 6);
  const std::vector<SurfacePoint> points = test::random_generators(mesh, 60, 4);
  for (const SurfacePoint& a : points) {
    for (const SurfacePoint& b : points) {
      std::vector<FaceId> in_a = faces_around(mesh, a), in_b = faces_around(mesh, b), both;
      std::sort(in_a.begin(), in_a.end());
      std::sort(in_b.begin(), in_b.end());
      std::set_intersection(in_a.begin(), in_a.end(), in_b.begin(), in_b.end(), std::back_inserter(both));
      const auto common = find_common_view(mesh, a, b);
      REQUIRE(common.has_value() == !both.empty());
      if (!common) continue;
      REQUIRE(common->first.face == both.front());
      REQUIRE(common->second.face == both.front());
      REQUIRE(canonical(mesh, common->first) == canonical(mesh, a));
      REQUIRE(canonical(mesh, common->second) == canonical(mesh, b));
    }
  }
}

TEST_CASE("surface normal: of a flat mesh the same unit vector everywhere") {
  const Mesh grid = test::make_grid(3, 2);
  for (const SurfacePoint& p : test::random_generators(grid, 30, 1)) {
    REQUIRE((surface_normal(grid, p) - Vec3(0, 0, 1)).norm() < 1e-14);
  }
}

TEST_CASE("surface normal: on an edge the mean of two faces, at a corner of a cube that of three by their angles") {
  const Mesh roof = test::make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}, {1, 0, 3}});
  const SurfacePoint ridge = edge_point(Mesh::halfedge(FaceId(0), 0), 0.5);
  CHECK((surface_normal(roof, ridge) - Vec3(0, 1, 1).normalized()).norm() < 1e-14);
  // One of the three sides of a cube's corner has two faces there: the angles count, not the faces.
  const Mesh corner = test::make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}},
                                      {{0, 1, 4}, {0, 4, 2}, {0, 2, 3}, {0, 3, 1}});
  CHECK((surface_normal(corner, vertex_point(corner, VertexId(0))) - Vec3(1, 1, 1).normalized()).norm() < 1e-14);
}

TEST_CASE("surface normal: of a sphere it points outwards") {
  const Mesh sphere = test::make_sphere(3);
  for (const SurfacePoint& p : test::random_generators(sphere, 60, 1)) {
    const Vec3 n = surface_normal(sphere, p);
    REQUIRE(n.norm() == Approx(1));
    REQUIRE(n.dot(position(sphere, p).normalized()) > 0.97);
  }
}

TEST_CASE("surface normal: zero where no face has an area") {
  const Mesh line = test::make_mesh({{0, 0, 0}, {4, 0, 0}, {1, 0, 0}}, {{0, 1, 2}});
  CHECK(surface_normal(line, vertex_point(line, VertexId(0))) == Vec3(0, 0, 0));
  CHECK(surface_normal(line, make_surface_point(FaceId(0), {0.3, 0.3, 0.4})) == Vec3(0, 0, 0));
}

TEST_CASE("the normal of a face has length 1 or 0, and the angles of its corners sum to 180 degrees") {
  const Mesh mesh = test::make_mesh({{0, 0, 0}, {2, 0, 0}, {0, 1e-3, 0}, {1, 0, 0}}, {{0, 1, 2}, {1, 0, 3}});
  CHECK(face_normal(mesh, FaceId(0)) == Vec3(0, 0, 1));
  CHECK(face_normal(mesh, FaceId(1)) == Vec3::Zero());
  for (const FaceId f : {FaceId(0), FaceId(1)}) {
    double sum = 0;
    for (int i = 0; i < 3; ++i) sum += corner_angle(mesh, Mesh::halfedge(f, i));
    CHECK(sum == Approx(3.14159265358979));
  }
  CHECK(corner_angle(mesh, Mesh::halfedge(FaceId(0), 0)) == Approx(1.570796326794897));
}

}  // namespace gvd::test_surface_point
