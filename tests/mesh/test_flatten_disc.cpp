// Convex combination maps of discs: flat ones stay as they are, convex borders give maps without a turned face.
#include <algorithm>
#include <cmath>
#include <vector>

#include "base/plane.hpp"
#include "mesh/flatten_disc.hpp"
#include "mesh/vertex_ring.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/random.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_flatten_disc {

std::vector<FaceId> all_faces(const Mesh& mesh) {
  std::vector<FaceId> faces;
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) faces.push_back(FaceId(f));
  return faces;
}

std::vector<VertexId> boundary_of(const Mesh& mesh) {
  VertexId first(0);
  while (!mesh.is_boundary(first)) first = VertexId(first.value() + 1);
  std::vector<VertexId> loop;
  HalfedgeId h = mesh.halfedge(first);
  do {
    loop.push_back(mesh.from(h));
    h = next_on_boundary(mesh, h);
  } while (mesh.from(h) != first);
  return loop;
}

std::vector<DiscBorderPoint> on_circle(const Mesh& mesh) {
  const std::vector<VertexId> loop = boundary_of(mesh);
  std::vector<DiscBorderPoint> border;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    border.push_back(
        {loop[i], unit_vector(6.283185307179586 * static_cast<double>(i) / static_cast<double>(loop.size()))});
  }
  return border;
}

TEST_CASE("flatten disc: mean values keep a flat disc") {
  const Mesh grid = test::make_grid(5, 7);
  std::vector<DiscBorderPoint> border;
  for (const VertexId v : boundary_of(grid)) border.push_back({v, grid.position(v).head<2>()});
  const PlaneDisc disc = flatten_disc(grid, all_faces(grid), border, DiscWeights::mean_value).value();
  for (std::int32_t v = 0; v < grid.vertex_count(); ++v) {
    CHECK((disc.at(VertexId(v)) - grid.position(VertexId(v)).head<2>()).norm() < 1e-12);
  }
  CHECK(is_oriented(grid, all_faces(grid), disc));
}

TEST_CASE("flatten disc: on a circle, no face is turned, with either kind of weights") {
  const Mesh half = test::make_half_sphere(3);
  for (const DiscWeights weights : {DiscWeights::mean_value, DiscWeights::uniform}) {
    const PlaneDisc disc = flatten_disc(half, all_faces(half), on_circle(half), weights).value();
    CHECK(is_oriented(half, all_faces(half), disc));
    for (const Vec2& point : disc.points) CHECK(point.norm() < 1 + 1e-12);
  }
}

TEST_CASE("flatten disc: a border that crosses itself turns faces round") {
  const Mesh half = test::make_half_sphere(2);
  std::vector<DiscBorderPoint> border = on_circle(half);
  for (DiscBorderPoint& b : border) b.point.y() *= b.point.x();
  const PlaneDisc disc = flatten_disc(half, all_faces(half), border, DiscWeights::mean_value).value();
  CHECK(!is_oriented(half, all_faces(half), disc));
}

TEST_CASE("boundary loop: a triangle's from each of its corners, and a grid's all round") {
  const Mesh triangle = test::make_triangle();
  const std::vector<VertexId> corners{VertexId(1), VertexId(2), VertexId(0)};
  CHECK(trace_boundary_loop(triangle, Mesh::halfedge(FaceId(0), 1)) == corners);
  const Mesh grid = test::make_grid(3, 2);
  CHECK(trace_boundary_loop(grid, grid.halfedge(VertexId(0))) == boundary_of(grid));
}

TEST_CASE("points round the origin: by angles and distances, none for the full turn") {
  const std::vector<Vec2> points = lay_round({0, 1.5, 3, 6.283185307179586}, {1, 2, 3});
  REQUIRE(points.size() == 3);
  CHECK(points[0] == Vec2(1, 0));
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(points[i].norm() == Approx(double(i + 1)));
    CHECK(std::atan2(points[i].y(), points[i].x()) == Approx(1.5 * double(i)));
  }
}

TEST_CASE("spacing: without a share of even spacing, numbers are scaled only") {
  std::vector<double> values{0, 1, 4};
  scale_and_even(values, 2, 0);
  CHECK(values == std::vector<double>{0, 0.5, 2});
}

TEST_CASE("spacing: with even spacing alone, the numbers do not count") {
  std::vector<double> values{0, 0, 0, 0, 4};
  scale_and_even(values, 2, 1);
  CHECK(values == std::vector<double>{0, 0.5, 1, 1.5, 2});
}

TEST_CASE("spacing: numbers that coincide are taken apart by the share of even spacing") {
  std::vector<double> values{0, 1, 1, 2};
  scale_and_even(values, 3, 0.1);
  CHECK(values[2] - values[1] == Approx(0.1));
  CHECK(values[3] == 3);
}

TEST_CASE("spacing: numbers ascend and end at the last one, bit by bit") {
  test::Random random(1);
  for (int trial = 0; trial < 2000; ++trial) {
    std::vector<double> values{0};
    for (int i = 0; i < 1 + trial % 7; ++i) values.push_back(values.back() + random.real(0, 1));
    const double last = random.real(0.1, 7);
    scale_and_even(values, last, 0.1);
    CHECK(values.front() == 0);
    CHECK(values.back() == last);
    CHECK(std::is_sorted(values.begin(), values.end()));
  }
}

}  // namespace gvd::test_flatten_disc
