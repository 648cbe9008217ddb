#include <algorithm>
#include <cmath>
#include <random>

#include "gvd/error.hpp"
#include "gvd/verify.hpp"
#include "support/catch.hpp"
#include "support/exact_fields.hpp"
#include "support/meshes.hpp"
#include "support/models.hpp"
#include "support/simple_obj.hpp"

namespace gvd::test_exact_distances {

/// A seeded surface point: inside a face, on an edge or on a vertex, in turn.
SurfacePoint random_point(const Mesh& mesh, std::mt19937& random, int turn) {
  const auto unit = [&] { return (double(random()) + 0.5) / (double(std::mt19937::max()) + 1); };
  const int f = std::min(mesh.face_count() - 1, int(unit() * mesh.face_count()));
  double a = unit(), b = unit() * (1 - a);
  if (turn % 3 == 1) b = 1 - a;
  if (turn % 3 == 2) a = 1, b = 0;
  return make_surface_point(FaceId(f), {a, b, std::max(0.0, 1 - a - b)});
}

std::vector<SurfacePoint> random_points(const Mesh& mesh, int count, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<SurfacePoint> points;
  for (int i = 0; i < count; ++i) points.push_back(random_point(mesh, random, i));
  return points;
}

TEST_CASE("on a flat convex mesh the distance is the straight line, from any kind of generator to any kind of point") {
  const Mesh mesh = test::make_grid(9, 7);
  const auto generators = random_points(mesh, 24, 1), points = random_points(mesh, 60, 2);
  std::vector<DistanceQuery> queries;
  for (const SurfacePoint& generator : generators) queries.push_back({generator, points});
  const auto distances = compute_exact_distances(mesh, queries);
  for (std::size_t g = 0; g < generators.size(); ++g) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      REQUIRE(distances[g][i] ==
              Approx((position(mesh, points[i]) - position(mesh, generators[g])).norm()).epsilon(1e-12).margin(1e-12));
    }
  }
}

TEST_CASE("exact distances agree with the reference's") {
  for (const std::string& name : test::list_references()) {
    const test::Reference reference = test::read_reference(name);
    const std::size_t count =
        std::min<std::size_t>(reference.mesh.face_count() > 10000 ? 2 : 4, reference.generators.size());
    std::vector<SurfacePoint> generators;
    for (std::size_t g = 0; g < count; ++g) generators.push_back(vertex_point(reference.mesh, reference.generators[g]));
    const test::DistanceFields fields = test::exact_vertex_fields(reference.mesh, generators);
    double worst = 0;
    for (std::size_t g = 0; g < count; ++g) {
      for (std::size_t v = 0; v < fields[g].size(); ++v) {
        const double expected = reference.distances[g][v];
        worst = std::max(worst, std::abs(fields[g][v] - expected) / std::max(expected, 1e-300));
      }
    }
    INFO(name);
    CHECK(worst < 1e-9);
  }
}

TEST_CASE("on an open cylinder the distance is that of the unrolled strip") {
  const int around = 48;
  const Mesh mesh = test::make_ring(around, 6);
  const double circumference = around * 2 * std::sin(M_PI / around);
  const auto unrolled = [&](const SurfacePoint& p) {
    const Vec3 at = position(mesh, p);
    double turn = std::atan2(at.y(), at.x()) / (2 * M_PI);
    if (turn < 0) turn += 1;
    const double whole = std::floor(turn * around), angle = 2 * M_PI * (whole / around), step = 2 * M_PI / around;
    const Vec2 from(std::cos(angle), std::sin(angle)), to(std::cos(angle + step), std::sin(angle + step));
    const double fraction = (Vec2(at.x(), at.y()) - from).norm() / (to - from).norm();
    return Vec2((whole + fraction) / around * circumference, at.z());
  };
  const auto generators = random_points(mesh, 12, 3), points = random_points(mesh, 40, 4);
  for (const SurfacePoint& generator : generators) {
    const auto distances = compute_exact_distances(mesh, {{generator, points}})[0];
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec2 difference = unrolled(points[i]) - unrolled(generator);
      const double across = std::fmod(std::abs(difference.x()), circumference);
      const double expected = std::hypot(std::min(across, circumference - across), difference.y());
      REQUIRE(distances[i] == Approx(expected).epsilon(1e-9).margin(1e-9));
    }
  }
}

TEST_CASE("distances are symmetric on every family, and where thin faces and flat parts are hard") {
  std::vector<test::NamedMesh> meshes = test::small_family();
  if (const auto rotor = test::find_model("rotor.m15.obj")) {
    meshes.push_back({"rotor", test::read_simple_obj(*rotor)});
  }
  for (const auto& [name, mesh] : meshes) {
    INFO(name);
    const auto points = random_points(mesh, 9, 5);
    std::vector<DistanceQuery> queries;
    for (const SurfacePoint& point : points) queries.push_back({point, points});
    const auto distances = compute_exact_distances(mesh, queries);
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::size_t j = 0; j < points.size(); ++j) {
        INFO(i << " " << j);
        if (std::isinf(distances[i][j])) {
          CHECK(std::isinf(distances[j][i]));
        } else {
          CHECK(distances[i][j] == Approx(distances[j][i]).epsilon(1e-9).margin(1e-12));
          CHECK(distances[i][j] >= (position(mesh, points[i]) - position(mesh, points[j])).norm() - 1e-12);
        }
      }
    }
  }
}

TEST_CASE("asking for few points gives the distances of asking for all") {
  const Mesh mesh = test::make_bumpy_sphere(3, 3);
  const SurfacePoint generator = random_points(mesh, 1, 6)[0];
  const auto points = random_points(mesh, 45, 7);
  const auto together = compute_exact_distances(mesh, {{generator, points}})[0];
  for (std::size_t i = 0; i < points.size(); ++i) {
    REQUIRE(compute_exact_distances(mesh, {{generator, {points[i]}}})[0][0] == Approx(together[i]).epsilon(1e-12));
  }
}

TEST_CASE("what no path reaches is infinitely far") {
  const Mesh mesh = test::make_two_components();
  const SurfacePoint here = vertex_point(mesh, VertexId(0));
  const SurfacePoint there = vertex_point(mesh, VertexId(mesh.vertex_count() - 1));
  const auto distances = compute_exact_distances(mesh, {{here, {there, here}}, {there, {there, here}}});
  CHECK(std::isinf(distances[0][0]));
  CHECK(distances[0][1] == 0);
  CHECK(distances[1][0] == 0);
  CHECK(std::isinf(distances[1][1]));
}

TEST_CASE("a face without area gives the distances or an error that says so, and never a crash") {
  // Between (0,0) and (2,0) lies a face that is a line, its third corner at (1,0).
  const auto face = [](int a, int b, int c) { return std::array{VertexId(a), VertexId(b), VertexId(c)}; };
  const Mesh mesh({{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0.7, -1, 0}, {1.2, -1, 0}},
                  {face(0, 1, 3), face(1, 0, 2), face(0, 4, 2), face(2, 4, 5), face(2, 5, 1)});
  const auto points = random_points(mesh, 12, 10);
  for (const SurfacePoint& generator : points) {
    try {
      const auto distances = compute_exact_distances(mesh, {{generator, points}})[0];
      for (const double d : distances) CHECK(std::isfinite(d));
    } catch (const Error& error) {
      CHECK(error.code() == ErrorCode::no_valid_result);
      CHECK_THAT(error.what(), Catch::Matchers::Contains("without area"));
    }
  }
}

TEST_CASE("the number of threads changes no byte") {
  const Mesh mesh = test::make_torus(24, 12);
  const auto points = random_points(mesh, 12, 8);
  std::vector<DistanceQuery> queries;
  for (const SurfacePoint& point : points) queries.push_back({point, points});
  VerifyOptions one;
  one.threads = 1;
  VerifyOptions four;
  four.threads = 4;
  CHECK(compute_exact_distances(mesh, queries, one) == compute_exact_distances(mesh, queries, four));
}

TEST_CASE("exact distances can be cancelled, and refuse what they can't do") {
  const Mesh mesh = test::make_sphere(2);
  const SurfacePoint good = vertex_point(mesh, VertexId(0)), bad{FaceId(99999), {1, 0, 0}};
  const auto code_of = [&](const std::vector<DistanceQuery>& queries, const VerifyOptions& options) {
    try {
      compute_exact_distances(mesh, queries, options);
    } catch (const Error& error) {
      return error.code();
    }
    FAIL("not refused");
    return ErrorCode::precondition;
  };
  CHECK(code_of({{bad, {good}}}, {}) == ErrorCode::precondition);
  CHECK(code_of({{good, {bad}}}, {}) == ErrorCode::precondition);
  VerifyOptions options;
  options.threads = -1;
  CHECK(code_of({{good, {good}}}, options) == ErrorCode::invalid_option);
  options.threads = 0;
  options.progress = [](std::string_view, double fraction) { return fraction < 0.3; };
  const auto points = random_points(mesh, 8, 9);
  CHECK(code_of(std::vector<DistanceQuery>(16, {good, points}), options) == ErrorCode::interrupted);
}

}  // namespace gvd::test_exact_distances
