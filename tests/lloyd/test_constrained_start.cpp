#include <algorithm>
#include <array>

#include "gvd/constrained_start.hpp"
#include "gvd/creases.hpp"
#include "gvd/error.hpp"
#include "gvd/sampling.hpp"
#include "support/catch.hpp"
#include "support/featured_meshes.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/random.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_constrained_start {

std::int64_t count(const ConstrainedStart& start, Freedom kind) {
  return std::count(start.freedom.begin(), start.freedom.end(), kind);
}

TEST_CASE("constrained start: without constraints the points stay, and all are free") {
  const Mesh box = test::make_plate(4, 0.5);
  const auto points = test::random_generators(box, 12, 1);
  const ConstrainedStart start = value_or_throw(constrain_start(box, points, {}));
  CHECK(start.points == points);
  CHECK(start.freedom.empty());
  CHECK(start.creases.empty());
}

TEST_CASE("constrained start: fixed generators come first, and sampled ones make room, the nearest first") {
  const Mesh box = test::make_plate(4, 0.5);
  const auto points = test::random_generators(box, 12, 1);
  StartOptions options;
  options.fixed = {points[5], vertex_point(box, VertexId(0))};
  const ConstrainedStart start = value_or_throw(constrain_start(box, points, options));
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
  const ConstrainedStart start = value_or_throw(constrain_start(box, test::random_generators(box, 60, 1), options));
  CHECK(start.points.size() == 60);
  CHECK(count(start, Freedom::fixed) == 8);
  CHECK(count(start, Freedom::on_crease) > 0);
  CHECK(count(start, Freedom::free) >= 12);
  CHECK_THROWS_AS(value_or_throw(constrain_start(box, test::random_generators(box, 7, 1), options)), Error);
}

TEST_CASE("constrained start: a boundary longer than the even spacing by any factor gets only its share") {
  std::vector<Vec3> positions;
  const Mesh grid = test::make_grid(4, 4);
  for (const Vec3& p : grid.positions()) positions.push_back({1e12 * p.x(), 1e-12 * p.y(), p.z()});
  const Mesh strip(positions, grid.face_vertices());
  StartOptions options;
  options.keep_boundary = true;
  const ConstrainedStart start = value_or_throw(constrain_start(strip, test::random_generators(strip, 30, 1), options));
  CHECK(start.points.size() <= 30);  // on such a strip, free points may coincide with points of the boundary
  CHECK(start.points.size() >= 25);
  CHECK(count(start, Freedom::on_crease) > 0);
  CHECK(count(start, Freedom::free) >= 6);
}

TEST_CASE("constrained start: a stick far thinner than the spacing has no creases at its scale") {
  std::vector<Vec3> positions;
  const Mesh box = test::make_plate(4, 0.5);
  for (const Vec3& p : box.positions()) positions.push_back({1e12 * p.x(), 1e-12 * p.y(), 1e-12 * p.z()});
  const Mesh stick(positions, box.face_vertices());
  StartOptions options;
  options.crease_angle = 30;
  const ConstrainedStart start = value_or_throw(constrain_start(stick, test::random_generators(stick, 30, 1), options));
  CHECK(start.creases.empty());
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
  const ConstrainedStart start = value_or_throw(constrain_start(box, points, options));
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
  CHECK_FALSE(value_or_throw(constrain_start(grid, test::random_generators(grid, 40, 1), prefers)).freedom.empty());
  CHECK(value_or_throw(constrain_start(grid, test::random_generators(grid, 4, 1), prefers)).freedom.empty());
  const ConstrainedStart few = value_or_throw(constrain_start(grid, test::random_generators(grid, 4, 1), keeps));
  CHECK(count(few, Freedom::fixed) == 4);
  prefers.are_listed = true;
  CHECK(value_or_throw(constrain_start(grid, test::random_generators(grid, 40, 1), prefers)).freedom.empty());
}

TEST_CASE("constrained start: boundaries leave samples for the faces, and small loops are left first") {
  const Mesh plane = test::make_plane_with_holes();
  StartOptions prefers;
  prefers.prefers_boundary = true;
  for (const int n : {60, 80, 100, 140, 200, 400}) {
    const ConstrainedStart start =
        value_or_throw(constrain_start(plane, test::random_generators(plane, n, 1), prefers));
    CHECK(std::ssize(start.points) == n);
    // Half of them, or as many as an even triangulation has there: 59 % of 80 vertices, and 54 % of 100.
    CHECK(double(count(start, Freedom::fixed) + count(start, Freedom::on_crease)) <= (n <= 100 ? 0.59 : 0.5) * n);
    CHECK(start.loops == 17);
    CHECK((start.unfollowed_loops == 0) == (start.enough_for_loops == 0));
    if (start.unfollowed_loops == 0) continue;
    CHECK(start.unfollowed_loops == 16);  // the outer loop is followed
    CHECK(start.enough_for_loops > n);
    const auto enough = test::random_generators(plane, int(start.enough_for_loops), 1);
    CHECK(value_or_throw(constrain_start(plane, enough, prefers)).unfollowed_loops == 0);
  }
  CHECK(value_or_throw(constrain_start(plane, test::random_generators(plane, 60, 1), prefers)).unfollowed_loops == 16);
  CHECK(value_or_throw(constrain_start(plane, test::random_generators(plane, 400, 1), prefers)).unfollowed_loops == 0);
}

TEST_CASE("constrained start: on a small piece of a plane, most generators are on its boundary") {
  const Mesh triangle = test::make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  StartOptions options;
  options.prefers_boundary = true;
  const ConstrainedStart start =
      value_or_throw(constrain_start(triangle, test::random_generators(triangle, 10, 1), options));
  CHECK(start.points.size() == 10);
  CHECK(count(start, Freedom::fixed) == 3);
  CHECK(count(start, Freedom::on_crease) >= 5);
}

TEST_CASE("constrained start: creases that are preferred are followed where at most half of the samples do it") {
  StartOptions prefers;
  prefers.crease_angle = 40;
  prefers.prefers_creases = true;
  const auto start_of = [&](const Mesh& mesh, int n) {
    return value_or_throw(constrain_start(mesh, test::random_generators(mesh, n, 1), prefers));
  };
  const Mesh box = test::make_plate(12, 0.5), thin = test::make_plate(12, 0.02);
  const ConstrainedStart followed = start_of(box, 200), few = start_of(box, 12), doubled = start_of(thin, 200);
  CHECK(count(followed, Freedom::fixed) == 8);
  CHECK(count(followed, Freedom::free) >= 100);
  CHECK(followed.enough_for_creases == 0);
  CHECK(few.creases.empty());
  CHECK(few.freedom.empty());
  CHECK(few.enough_for_creases > 12);
  // The thin box has about as many generators on creases, and as many again would be added.
  CHECK(doubled.creases.empty());
  CHECK(doubled.enough_for_creases > 200);
  CHECK(few.leaves_creases);
  CHECK_FALSE(start_of(box, int(few.enough_for_creases)).creases.empty());
  prefers.prefers_creases = false;
  CHECK_FALSE(start_of(thin, 200).creases.empty());
}

TEST_CASE("constrained start: creases that no usual number of generators follows are left, however long they are") {
  const Mesh plate = test::make_plate(12, 0.5);
  std::vector<Vec3> positions;
  std::vector<std::array<VertexId, 3>> faces;
  for (const VertexId v : plate.vertices()) {
    const Vec3& p = plate.position(v);
    positions.push_back({p.x(), 0.02 * p.y(), 0.004 * p.z()});
  }
  for (const FaceId f : plate.faces()) faces.push_back(plate.vertices(f));
  const Mesh needle(std::move(positions), std::move(faces));
  StartOptions prefers;
  prefers.crease_angle = 40;
  prefers.prefers_creases = true;
  const ConstrainedStart start =
      value_or_throw(constrain_start(needle, test::random_generators(needle, 100, 1), prefers));
  CHECK(start.creases.empty());
  CHECK(start.leaves_creases);
  CHECK(start.enough_for_creases == 0);
}

TEST_CASE("constrained start: samples leave room where generators will be added") {
  const Mesh box = test::make_plate(12, 0.02);
  StartOptions options;
  options.crease_angle = 40;
  const auto points = test::random_generators(box, 300, 1);
  CHECK(value_or_throw(constrain_start(box, points, options)).points.size() == 300);
  options.leaves_room = true;
  const std::size_t left = value_or_throw(constrain_start(box, points, options)).points.size();
  CHECK(left < 300);
  CHECK(left >= 250);
}

TEST_CASE("constrained start: the noise of a smooth surface is no crease that is preferred") {
  StartOptions prefers;
  prefers.crease_angle = 40;
  prefers.prefers_creases = true;
  const Mesh sphere = test::make_sphere(4);
  for (const double noise : {0.01, 0.02, 0.03}) {
    test::Random random(7);
    std::vector<Vec3> positions;
    std::vector<std::array<VertexId, 3>> faces;
    for (const VertexId v : sphere.vertices())
      positions.push_back((1 + random.real(-noise, noise)) * sphere.position(v));
    for (const FaceId f : sphere.faces()) faces.push_back(sphere.vertices(f));
    const Mesh noisy(std::move(positions), std::move(faces));
    for (const int n : {100, 500}) {
      CAPTURE(noise, n);
      CHECK(value_or_throw(constrain_start(noisy, test::random_generators(noisy, n, 1), prefers)).creases.empty());
    }
    if (noise > 0.02) CHECK_FALSE(find_creases(noisy, {40, false}).empty());
  }
}

}  // namespace gvd::test_constrained_start
