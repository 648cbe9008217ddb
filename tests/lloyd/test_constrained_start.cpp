#include <algorithm>

#include "gvd/constrained_start.hpp"
#include "gvd/error.hpp"
#include "gvd/sampling.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

namespace gvd::test_constrained_start {

std::int64_t count(const ConstrainedStart& start, Freedom kind) {
  return std::count(start.freedom.begin(), start.freedom.end(), kind);
}

TEST_CASE("constrained start: without constraints the points stay, and all are free") {
  const Mesh box = test::make_plate(4, 0.5);
  const auto points = test::random_generators(box, 12, 1);
  const ConstrainedStart start = constrain_start(box, points, {});
  CHECK(start.points == points);
  CHECK(start.freedom.empty());
  CHECK(start.creases.empty());
}

TEST_CASE("constrained start: fixed generators come first, and sampled ones make room, the nearest first") {
  const Mesh box = test::make_plate(4, 0.5);
  const auto points = test::random_generators(box, 12, 1);
  StartOptions options;
  options.fixed = {points[5], vertex_point(box, VertexId(0))};
  const ConstrainedStart start = constrain_start(box, points, options);
  REQUIRE(start.points.size() == 12);
  CHECK(start.points[0] == points[5]);
  CHECK(start.points[1] == options.fixed[1]);
  CHECK(count(start, Freedom::fixed) == 2);
  // The point in the place of the first fixed one is gone, and so is the nearest to the second one.
  const auto distance = [&](const SurfacePoint& p) { return (position(box, p) - box.position(VertexId(0))).norm(); };
  double gone = 0, least = 1e9;
  for (const SurfacePoint& p : points) {
    if (std::find(start.points.begin(), start.points.end(), p) == start.points.end()) gone = distance(p);
    if (!(p == points[5])) least = std::min(least, distance(p));
  }
  CHECK(gone == least);
}

TEST_CASE("constrained start: corners and creases have generators, and enough are left for the faces") {
  const Mesh box = test::make_plate(4, 0.5);
  StartOptions options;
  options.crease_angle = 30;
  const ConstrainedStart start = constrain_start(box, test::random_generators(box, 60, 1), options);
  CHECK(start.points.size() == 60);
  CHECK(count(start, Freedom::fixed) == 8);
  CHECK(count(start, Freedom::on_crease) > 0);
  CHECK(count(start, Freedom::free) >= 12);
  CHECK_THROWS_AS(constrain_start(box, test::random_generators(box, 7, 1), options), Error);
}

TEST_CASE("constrained start: creases longer than the even spacing by any factor get only their share") {
  std::vector<Vec3> positions;
  const Mesh box = test::make_plate(4, 0.5);
  for (const Vec3& p : box.positions()) positions.push_back({1e12 * p.x(), 1e-12 * p.y(), 1e-12 * p.z()});
  const Mesh stick(positions, box.face_vertices());
  StartOptions options;
  options.crease_angle = 30;
  const ConstrainedStart start = constrain_start(stick, test::random_generators(stick, 30, 1), options);
  CHECK(start.points.size() == 30);
  CHECK(count(start, Freedom::on_crease) > 0);
  CHECK(count(start, Freedom::free) >= 6);
}

TEST_CASE("constrained start: listed points stay, and those on creases are kept there") {
  const Mesh box = test::make_plate(4, 0.5);
  StartOptions options;
  options.are_listed = true;
  options.crease_angle = 30;
  const auto creases = find_creases(box, {30});
  const std::vector<SurfacePoint> points{vertex_point(box, box.from(box.halfedge(creases[0]))),
                                         edge_point(box.halfedge(creases[0]), 0.3),
                                         make_surface_point(FaceId(0), {0.4, 0.3, 0.3})};
  const ConstrainedStart start = constrain_start(box, points, options);
  CHECK(start.points == points);
  REQUIRE(start.freedom.size() == 3);
  CHECK(start.freedom[1] == Freedom::on_crease);
  CHECK(start.freedom[2] == Freedom::free);
}

TEST_CASE("constrained start: the boundary is preferred where samples are left beside it, and kept where asked") {
  const Mesh grid = test::make_grid(6, 6);
  StartOptions prefers, keeps;
  prefers.prefers_boundary = true;
  keeps.keep_boundary = true;
  CHECK_FALSE(constrain_start(grid, test::random_generators(grid, 40, 1), prefers).freedom.empty());
  CHECK(constrain_start(grid, test::random_generators(grid, 4, 1), prefers).freedom.empty());
  const ConstrainedStart few = constrain_start(grid, test::random_generators(grid, 4, 1), keeps);
  CHECK(count(few, Freedom::fixed) == 4);
  prefers.are_listed = true;
  CHECK(constrain_start(grid, test::random_generators(grid, 40, 1), prefers).freedom.empty());
}

}  // namespace gvd::test_constrained_start
