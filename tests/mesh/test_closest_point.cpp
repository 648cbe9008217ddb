#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "gvd/closest_point.hpp"
#include "gvd/error.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/random.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_closest_point {

TEST_CASE("closest point on a face: above its inside, beside an edge, beyond a corner") {
  const Mesh mesh = test::make_mesh({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{0, 1, 2}});
  const ClosestPoint inside = closest_point_on_face(mesh, FaceId(0), {1, 1, 3});
  CHECK(inside.distance == Approx(3));
  CHECK(inside.point.kind() == SurfacePoint::Kind::face);
  CHECK((position(mesh, inside.point) - Vec3(1, 1, 0)).norm() < 1e-14);
  const ClosestPoint edge = closest_point_on_face(mesh, FaceId(0), {1, -2, 0});
  CHECK(edge.distance == Approx(2));
  CHECK(edge.point == edge_point(Mesh::halfedge(FaceId(0), 0), 0.25));
  const ClosestPoint corner = closest_point_on_face(mesh, FaceId(0), {-3, -4, 0});
  CHECK(corner.distance == Approx(5));
  CHECK(corner.point == vertex_point(mesh, VertexId(0)));
}

TEST_CASE("closest point on a face without area: on its longest edge") {
  const Mesh mesh = test::make_mesh({{0, 0, 0}, {4, 0, 0}, {1, 0, 0}}, {{0, 1, 2}});
  const ClosestPoint found = closest_point_on_face(mesh, FaceId(0), {3, 2, 0});
  CHECK(found.distance == Approx(2));
  CHECK((position(mesh, found.point) - Vec3(3, 0, 0)).norm() < 1e-14);
}

/// Compares a tree with a search through all faces, near the surface and far from it. `rounding` is that of the quick
/// search, which projects on the planes of needles; mesh units.
void check_against_all_faces(const Mesh& mesh, double rounding) {
  const ClosestPointTree tree(mesh);
  test::Random random(6);
  for (int round = 0; round < 100; ++round) {
    const double size = std::pow(10, random.real(-2, 1));
    const Vec3 query = mesh.position(VertexId(random.below(mesh.vertex_count()))) +
                       size * Vec3(random.real(-1, 1), random.real(-1, 1), random.real(-1, 1));
    ClosestPoint best = closest_point_on_face(mesh, FaceId(0), query);
    for (int f = 1; f < mesh.face_count(); ++f) {
      const ClosestPoint found = closest_point_on_face(mesh, FaceId(f), query);
      if (found.distance < best.distance) best = found;
    }
    const ClosestPoint found = tree.query(query);
    REQUIRE(found.distance == best.distance);
    REQUIRE(found.point.face == best.point.face);
    REQUIRE((position(mesh, found.point) - query).norm() == Approx(best.distance).epsilon(1e-9).margin(1e-11));
    REQUIRE(tree.nearest_face(query).distance == Approx(best.distance).epsilon(1e-9).margin(rounding));
  }
}

/// Two fans of needles with the right angle between them, each from a corner of a strip to points of the other side.
/// The strips are a thousand times as long as they are wide.
Mesh make_rod(int needles, const Eigen::Matrix3d& turn, const Vec3& offset) {
  std::vector<Vec3> positions{{0, 0, 0}, {0, 1, 1}};
  std::vector<std::array<int, 3>> faces;
  for (int i = 0; i <= needles; ++i) positions.emplace_back(1000.0 * i / needles, 1, 0);
  for (Vec3& p : positions) p = turn * p + offset;
  for (int i = 2; i < needles + 2; ++i) faces.insert(faces.end(), {{0, i + 1, i}, {1, i, i + 1}});
  return test::make_mesh(positions, faces);
}

TEST_CASE("closest point: as a search through all faces") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    check_against_all_faces(mesh, 1e-14);
  }
}

TEST_CASE("closest point: as a search through all faces among needles, along the axes and oblique to them") {
  for (const double angle : {0.0, 1.0}) {
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    for (const Vec3& offset : {Vec3(0, 0, 0), Vec3(-2e4, 1e4, 6e3)}) {
      CAPTURE(angle, offset.x());
      check_against_all_faces(make_rod(50, turn, offset), 1e-10);
    }
  }
}

TEST_CASE("closest point: a corner that the rounding of a needle's foot puts at the end of its longest side is found") {
  // The short side is 5e-9 of the long ones, whose squares are equal in doubles. Other faces are at other heights.
  std::vector<Vec3> positions{{0, 0, 0}, {1000, 0, 0}, {1000, 5e-6, 0}};
  std::vector<std::array<int, 3>> faces{{0, 1, 2}};
  for (const double height : {9e-6, 20.0, 30.0, 40.0, 50.0, 60.0}) {
    const int first = int(positions.size());
    for (const double x : {0.0, 1000.0, 500.0}) positions.emplace_back(x, height, x == 500 ? 400 : 0);
    faces.push_back({first, first + 1, first + 2});
  }
  const Mesh mesh = test::make_mesh(positions, faces);
  const ClosestPoint found = ClosestPointTree(mesh).query({1000, 6e-6, 0});
  CHECK(found.point.face == FaceId(0));
  CHECK(found.distance == Approx(1e-6));
}

TEST_CASE("the quick distance from a cap is that of its closest point, however flat the cap is") {
  test::Random random(3);
  for (double height = 1; height > 1e-9; height /= 10) {
    CAPTURE(height);
    const Mesh cap = test::make_mesh({{0, 0, 0}, {40, 0, 0}, {17.3, 0.6 * height, 0.8 * height}}, {{0, 1, 2}});
    const ClosestPointTree tree(cap);
    for (int round = 0; round < 50; ++round) {
      const double a = random.real(0, 1), b = random.real(0, 1 - a);
      const Vec3 on = position(cap, {FaceId(0), {a, b, 1 - a - b}});
      for (const double away : {0.0, 1e-3, 1.0}) {
        const Vec3 query = on + away * Vec3(0, -0.8, 0.6);
        REQUIRE(tree.distance(query, FaceId(0)) == Approx(away).epsilon(1e-9).margin(1e-10));
      }
    }
  }
}

TEST_CASE("closest point: a point of the surface is found where it is") {
  const Mesh mesh = test::make_bumpy_sphere(2, 3);
  const ClosestPointTree tree(mesh);
  for (const SurfacePoint& p : test::random_generators(mesh, 60, 2)) {
    const ClosestPoint found = tree.query(position(mesh, p));
    REQUIRE(found.distance < 1e-14);
    REQUIRE((position(mesh, found.point) - position(mesh, p)).norm() < 1e-14);
  }
}

TEST_CASE("closest point: among faces at the same distance the smallest wins") {
  const Mesh grid = test::make_grid(4, 3);
  const ClosestPointTree tree(grid);
  for (int v = 0; v < grid.vertex_count(); ++v) {
    const ClosestPoint found = tree.query(grid.position(VertexId(v)) + Vec3(0, 0, 1));
    const std::vector<FaceId> faces = faces_around(grid, vertex_point(grid, VertexId(v)));
    CHECK(found.distance == 1);
    CHECK(found.point.face == *std::min_element(faces.begin(), faces.end()));
  }
}

TEST_CASE("closest point: a query without a finite distance is refused") {
  const Mesh mesh = test::make_tetrahedron();
  const ClosestPointTree tree(mesh);
  CHECK_THROWS_AS(tree.query({std::nan(""), 0, 0}), Error);
  CHECK_THROWS_AS(tree.query({1e200, 1e200, 0}), Error);
  CHECK_THROWS_AS(tree.query({std::numeric_limits<double>::infinity(), 0, 0}), Error);
}

TEST_CASE("nearest face: as a search by closest points, near the surface and far from it, from any guess") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    const ClosestPointTree tree(mesh);
    test::Random random(7);
    for (int round = 0; round < 200; ++round) {
      const double size = std::pow(10, random.real(-3, 1));
      const Vec3 point = mesh.position(VertexId(random.below(mesh.vertex_count()))) +
                         size * Vec3(random.real(-1, 1), random.real(-1, 1), random.real(-1, 1));
      const NearestFace found = tree.nearest_face(point, FaceId(random.below(mesh.face_count())));
      const double wanted = tree.query(point).distance;
      REQUIRE(found.distance == Approx(wanted).epsilon(1e-9).margin(1e-14));
      REQUIRE(closest_point_on_face(mesh, found.face, point).distance == Approx(wanted).epsilon(1e-9).margin(1e-14));
      const FaceId any(random.below(mesh.face_count()));
      REQUIRE(tree.distance(point, any) == Approx(closest_point_on_face(mesh, any, point).distance).epsilon(1e-9));
    }
  }
}

TEST_CASE("a face without area has the distance of its longest edge") {
  const Mesh mesh = test::make_mesh({{0, 0, 0}, {4, 0, 0}, {1, 0, 0}}, {{0, 1, 2}});
  const ClosestPointTree line(mesh);
  CHECK(line.distance({3, 2, 0}, FaceId(0)) == Approx(2));
  CHECK(line.nearest_face({-3, 4, 0}).distance == Approx(5));
  CHECK(line.nearest_face({7, 0, 4}).distance == Approx(5));
}

TEST_CASE("foot on edge: a point of the line has its own parameter, and moves across change nothing") {
  const Mesh mesh = test::make_grid(2, 2);
  for (std::int32_t i = 0; i < mesh.halfedge_count(); ++i) {
    const HalfedgeId h(i);
    const Vec3& from = mesh.position(mesh.from(h));
    const Vec3 along = mesh.position(mesh.to(h)) - from;
    const Vec3 across = along.unitOrthogonal();
    for (const double t : {-0.5, 0.0, 0.25, 1.0, 2.0}) {
      CHECK(foot_on_edge(mesh, h, from + t * along) == Approx(t).margin(1e-12));
      CHECK(foot_on_edge(mesh, h, from + t * along + 3 * across) == Approx(t).margin(1e-12));
    }
  }
}

}  // namespace gvd::test_closest_point
