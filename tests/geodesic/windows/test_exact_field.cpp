#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "gvd/error.hpp"
#include "gvd/exact_field.hpp"
#include "gvd/geodesic_tracing.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/many_threads.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_exact_field {

/// Whether a path leads through a vertex between its ends: round a saddle or a corner of the boundary.
bool bends(const GeodesicPath& path) {
  for (std::size_t i = 1; i + 1 < path.points.size(); ++i) {
    if (path.points[i].kind() == SurfacePoint::Kind::vertex) return true;
  }
  return false;
}

ErrorCode code_of(const Mesh& mesh, const std::vector<SurfacePoint>& generators, const ExactFieldOptions& options) {
  try {
    ExactField(mesh, generators, options);
  } catch (const Error& error) {
    return error.code();
  }
  FAIL("not refused");
  return ErrorCode::precondition;
}

TEST_CASE("at a generator everything is zero") {
  const Mesh mesh = test::make_torus(24, 12);
  const auto generators = test::random_generators(mesh, 9, 1);
  const ExactField field(mesh, generators);
  for (std::size_t g = 0; g < generators.size(); ++g) {
    CHECK(field.nearest(generators[g]).distance < 1e-12);
    CHECK(field.nearest(generators[g]).generator.index() == g);
    CHECK(field.path(generators[g]).length < 1e-12);
    CHECK(field.departure(generators[g]).norm() < 1e-12);
  }
}

TEST_CASE("paths round a saddle of many faces are as long as their distances, each time they are asked for") {
  // Round the middle the angles sum to more than a full turn: paths to the other side bend there.
  constexpr int kSides = 300;
  std::vector<Vec3> positions{Vec3::Zero()};
  std::vector<std::array<int, 3>> faces;
  for (int i = 0; i < kSides; ++i) {
    const double turn = 2 * std::numbers::pi * i / kSides;
    positions.emplace_back(std::cos(turn), std::sin(turn), std::sin(3 * turn));
    faces.push_back({0, 1 + i, 1 + (i + 1) % kSides});
  }
  const Mesh mesh = test::make_mesh(std::move(positions), faces);
  const ExactField field(mesh, {vertex_point(mesh, VertexId(1)), vertex_point(mesh, VertexId(101))});
  int bent = 0;
  for (int round = 0; round < 2; ++round) {
    for (const VertexId v : mesh.vertices()) {
      for (const GeneratorId g : {GeneratorId(0), GeneratorId(1)}) {
        const GeodesicPath path = field.path(vertex_point(mesh, v), g);
        if (g != field.label(v)) continue;
        double length = 0;
        for (std::size_t i = 1; i < path.points.size(); ++i) {
          length += (position(mesh, path.points[i]) - position(mesh, path.points[i - 1])).norm();
        }
        CHECK(path.complete);
        CHECK(length == Approx(field.distance(v)).epsilon(1e-12).margin(1e-14));
        bent += bends(path);
      }
    }
  }
  CHECK(bent > 20);
}

TEST_CASE("a geodesic traced in the direction of departure arrives") {
  int traced = 0;
  for (const auto& [name, mesh] : test::small_family()) {
    const auto generators = test::random_generators(mesh, 5, 2), points = test::random_generators(mesh, 60, 3);
    const ExactField field(mesh, generators);
    for (std::size_t i = 0; i < points.size(); ++i) {
      INFO(name << " " << i);
      const GeodesicPath path = field.path(points[i]);
      CHECK(path.complete == path.generator.valid());
      if (!path.generator.valid()) {
        CHECK(field.departure(points[i]) == Vec2::Zero());
        continue;
      }
      const Vec2 tangent = field.departure(points[i]);
      CHECK(tangent.norm() == Approx(path.length).epsilon(1e-12).margin(1e-14));
      if (bends(path)) continue;
      const GeodesicTrace trace = trace_geodesic(mesh, generators[path.generator.index()], tangent);
      CHECK((position(mesh, trace.points.back()) - position(mesh, points[i])).norm() < 1e-8 * mesh.bbox_diagonal());
      ++traced;
    }
  }
  CHECK(traced > 300);
}

TEST_CASE("any number of threads leaves the same field to the last bit") {
  const Mesh mesh = test::make_bumpy_sphere(5, 2);
  const auto generators = test::random_generators(mesh, 8, 4), points = test::random_generators(mesh, 200, 5);
  const ExactField one(mesh, generators, {{}, {}, 1});
  test::with_many_threads([&] {
    for (const int threads : {0, 2, 3, 8}) {
      INFO(threads);
      const ExactField field(mesh, generators, {{}, {}, threads});
      for (const SurfacePoint& p : points) {
        CHECK(field.nearest(p).distance == one.nearest(p).distance);
        CHECK(field.nearest(p).generator == one.nearest(p).generator);
      }
    }
  });
}

TEST_CASE("a field up to a largest distance is the same there, and has nothing beyond") {
  for (const auto& [name, mesh] : test::small_family()) {
    const auto generators = test::random_generators(mesh, 3, 2), points = test::random_generators(mesh, 60, 3);
    const ExactField all(mesh, generators);
    for (const double share : {0.0, 0.02, 0.1, 0.3}) {
      const double limit = share * mesh.bbox_diagonal();
      const ExactField near(mesh, generators, {.max_distance = limit});
      CAPTURE(name, limit);
      for (const VertexId v : mesh.vertices()) {
        if (all.distance(v) > limit) CHECK_FALSE(near.label(v).valid());
        CHECK(near.distance(v) ==
              (all.distance(v) > limit ? Approx(kInfinity) : Approx(all.distance(v)).epsilon(1e-13)));
      }
      for (const SurfacePoint& p : points) {
        const ExactField::Nearest nearest = near.nearest(p), known = all.nearest(p);
        const GeodesicPath path = near.path(p);
        CHECK(path.complete == (known.distance <= limit));
        CHECK(nearest.generator.valid() == (known.distance <= limit));
        if (known.distance <= limit) CHECK(nearest.distance == Approx(known.distance).epsilon(1e-13));
        CHECK(path.length == (known.distance <= limit ? Approx(known.distance).epsilon(1e-12) : Approx(kInfinity)));
      }
    }
  }
}

TEST_CASE("distances of the vertices alone are those of the field to the last bit") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    const auto generators = test::random_generators(mesh, 5, 6);
    const ExactFieldOptions options{.offsets = {0, 0.01, 0.02, 0, 0.1}, .max_distance = 0.4 * mesh.bbox_diagonal()};
    const ExactField field(mesh, generators, options);
    const VertexDistances alone = compute_vertex_distances(mesh, generators, options);
    REQUIRE(alone.distance.count() == mesh.vertex_count());
    REQUIRE(alone.label.count() == mesh.vertex_count());
    for (const VertexId v : mesh.vertices()) {
      CHECK(alone.distance[v] == field.distance(v));
      CHECK(alone.label[v] == field.label(v));
    }
  }
  CHECK_THROWS_AS(compute_vertex_distances(test::make_torus(24, 12), std::vector<SurfacePoint>()), Error);
}

TEST_CASE("an exact field refuses what it can't do") {
  const Mesh mesh = test::make_sphere(1);
  const SurfacePoint good = vertex_point(mesh, VertexId(0)), other = vertex_point(mesh, VertexId(5));
  CHECK(code_of(mesh, {}, {}) == ErrorCode::precondition);
  CHECK(code_of(mesh, {good, good}, {}) == ErrorCode::precondition);
  CHECK(code_of(mesh, {{FaceId(9999), {1, 0, 0}}}, {}) == ErrorCode::precondition);
  CHECK(code_of(mesh, {good, other}, {{0.5}, {}}) == ErrorCode::precondition);
  CHECK(code_of(mesh, {good, other}, {{0.5, -1}, {}}) == ErrorCode::invalid_option);
  CHECK(code_of(mesh, {good}, {{std::numeric_limits<double>::quiet_NaN()}, {}}) == ErrorCode::invalid_option);
  CHECK(code_of(mesh, {good}, {{}, {}, -1}) == ErrorCode::invalid_option);
  CHECK(code_of(mesh, {good}, {.max_distance = -1}) == ErrorCode::invalid_option);
  CHECK(code_of(mesh, {good}, {.max_distance = std::numeric_limits<double>::quiet_NaN()}) == ErrorCode::invalid_option);
  CHECK(code_of(mesh, {good}, {{}, [](std::string_view, double) { return false; }}) == ErrorCode::interrupted);
}

}  // namespace gvd::test_exact_field
