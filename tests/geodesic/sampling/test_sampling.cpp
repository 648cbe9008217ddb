// The promises of gvd/sampling.hpp for all samplings, and of random and Poisson points.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "support/cancelled.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/samples.hpp"

namespace gvd::test_sampling {

using test::all_distinct;
using test::error_of;
using test::kCounted;
using test::kInfinity;
using test::least_spacing;
using test::sample;

TEST_CASE("property 1: exactly N different generators, also more than there are vertices and faces") {
  for (const auto& [name, mesh] : test::small_family()) {
    for (const Sampling kind : kCounted) {
      for (const int count : {1, 2, 100, mesh.vertex_count(), mesh.vertex_count() + 10, 2 * mesh.face_count()}) {
        INFO(name << ", kind " << int(kind) << ", " << count);
        const auto points = sample(mesh, kind, count);
        REQUIRE(points.size() == static_cast<std::size_t>(count));
        REQUIRE(all_distinct(mesh, points));
        for (const SurfacePoint& p : points) {
          REQUIRE((p.face.valid() && p.face.value() < mesh.face_count()));
          REQUIRE(make_surface_point(p.face, p.bary).kind() == p.kind());
        }
      }
    }
  }
}

TEST_CASE("one triangle takes any number of generators") {
  const Mesh triangle({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{VertexId(0), VertexId(1), VertexId(2)}});
  for (const Sampling kind : kCounted) {
    for (const int count : {1, 2, 3, 4, 50, 1000}) {
      const auto points = sample(triangle, kind, count);
      REQUIRE(points.size() == static_cast<std::size_t>(count));
      REQUIRE(all_distinct(triangle, points));
    }
  }
}

TEST_CASE("property 2: the same seed gives the same points, another one others") {
  for (const auto& [name, mesh] : test::small_family()) {
    for (const Sampling kind : kCounted) {
      INFO(name << ", kind " << int(kind));
      CHECK(sample(mesh, kind, 20, 5) == sample(mesh, kind, 20, 5));
      CHECK(sample(mesh, kind, 20, 5) != sample(mesh, kind, 20, 6));
    }
  }
}

TEST_CASE("random numbers are those that the C++ standard specifies") {
  // The 10000th output of a default-constructed std::mt19937_64 is in the standard; this is the engine's own seed.
  std::mt19937_64 engine;
  engine.discard(9999);
  CHECK(engine() == 9981545732273789042ULL);
  const Mesh square = test::make_grid(1, 1);
  const auto points = sample(square, Sampling::random, 1, 7);
  std::mt19937_64 same(7);
  const auto real = [&] { return double(same() >> 11) / 9007199254740992.0; };
  const double face = real(), root = std::sqrt(real()), along = real();
  CHECK(points[0].face == FaceId(face < 0.5 ? 0 : 1));
  CHECK(points[0].bary[1] == Approx(root * (1 - along)));
}

TEST_CASE("random points are uniform by area") {
  const Mesh grid = test::make_grid(4, 1);
  std::array<int, 4> columns{};
  const auto points = sample(grid, Sampling::random, 20000, 3);
  Vec3 mean = Vec3::Zero();
  for (const SurfacePoint& p : points) {
    const Vec3 x = position(grid, p);
    ++columns[static_cast<std::size_t>(x.x())];
    mean += x / 20000;
    REQUIRE(p.kind() == SurfacePoint::Kind::face);
  }
  // Six standard deviations: sqrt(20000 / 4 * 3 / 4) = 61 points; 1 / sqrt(12 * 20000) = 0.002 for the height.
  for (const int column : columns) CHECK(std::abs(column - 5000) < 370);
  CHECK(std::abs(mean.y() - 0.5) < 0.0125);
}

TEST_CASE("sampled vertices are different ones, all of them if asked for, and each as likely as any other") {
  const Mesh mesh = test::make_grid(5, 3);
  std::vector<int> drawn(static_cast<std::size_t>(mesh.vertex_count()), 0);
  constexpr int kDraws = 4000, kCount = 6;
  for (int seed = 0; seed < kDraws; ++seed) {
    std::set<int> ids;
    for (const SurfacePoint& p : sample(mesh, Sampling::vertices, kCount, static_cast<std::uint64_t>(seed))) {
      REQUIRE(p.kind() == SurfacePoint::Kind::vertex);
      const auto corner = static_cast<std::size_t>(std::max_element(p.bary.begin(), p.bary.end()) - p.bary.begin());
      ids.insert(mesh.vertices(p.face)[corner].value());
    }
    REQUIRE(ids.size() == kCount);
    for (const int id : ids) ++drawn[id];
  }
  const double expected = double(kDraws) * kCount / mesh.vertex_count();
  // Five standard deviations of a binomial distribution.
  for (const int count : drawn) CHECK(std::abs(count - expected) < 5 * std::sqrt(expected));
  CHECK(sample(mesh, Sampling::vertices, mesh.vertex_count(), 1).size() ==
        static_cast<std::size_t>(mesh.vertex_count()));
  CHECK_THROWS_AS(sample(mesh, Sampling::vertices, mesh.vertex_count() + 1, 1), Error);
}

TEST_CASE("poisson points keep a spacing that random points do not have") {
  struct Case {
    std::string name;
    Mesh mesh;
  };
  for (const auto& [name, mesh] : std::vector<Case>{{"sphere", test::make_sphere(3)},
                                                    {"plate", test::make_plate(20)},
                                                    {"torus", test::make_torus(48, 20)},
                                                    {"one square", test::make_grid(1, 1)}}) {
    const double area = compute_mesh_summary(mesh).area;
    for (const int count : {50, 300}) {
      for (std::uint64_t seed = 0; seed < 3; ++seed) {
        INFO(name << ", " << count << ", seed " << seed);
        // The spacing of the densest packing in the plane; elimination reaches some 0.7 of it, random points some 0.7
        // divided by the square root of their number.
        const double densest = std::sqrt(2 * area / (std::numbers::sqrt3 * count));
        CHECK(least_spacing(mesh, sample(mesh, Sampling::poisson, count, seed)) > 0.6 * densest);
        CHECK(least_spacing(mesh, sample(mesh, Sampling::random, count, seed)) < 0.25 * densest);
      }
    }
  }
}

TEST_CASE("more points than a mesh allows, or an invalid option, is an error with a clear message") {
  const Mesh sphere = test::make_sphere(1);
  SamplingOptions options;
  options.count = 0;
  CHECK(error_of(sphere, options) == ErrorCode::invalid_option);
  options.kind = Sampling::covering_radius;
  for (const double radius : {0.0, -1.0, kInfinity, std::nan("")}) {
    options.radius = radius;
    CHECK(error_of(sphere, options) == ErrorCode::invalid_option);
  }
  options.radius = 1e-9;
  CHECK(error_of(sphere, options) == ErrorCode::precondition);
  options.kind = Sampling::farthest;
  options.count = 2'000'000'000;
  CHECK(error_of(sphere, options) == ErrorCode::precondition);
  options.kind = Sampling::poisson;
  CHECK(error_of(sphere, options) == ErrorCode::precondition);
  options.kind = Sampling::random;
  CHECK(error_of(sphere, options) == ErrorCode::precondition);
  options.count = 1;
  options.progress = [](std::string_view, double) { return false; };
  CHECK(error_of(sphere, options) == ErrorCode::interrupted);
}

TEST_CASE("progress moves within the first insertions, which take longest on large meshes") {
  const Mesh mesh = test::make_sphere(6);
  for (const Sampling kind : {Sampling::farthest, Sampling::poisson, Sampling::covering_radius}) {
    SamplingOptions options;
    options.kind = kind;
    options.count = 3;
    options.radius = 1;
    std::vector<double> told;
    options.progress = [&](std::string_view step, double fraction) {
      CHECK((fraction >= 0 && fraction <= 1));
      if (step == "sampling") told.push_back(fraction);
      return true;
    };
    sample_generators(mesh, options);
    CAPTURE(static_cast<int>(kind), told);
    CHECK(std::is_sorted(told.begin(), told.end()));
    told.erase(std::unique(told.begin(), told.end()), told.end());
    CHECK(told.size() > 6);  // without those within insertions there were one for each generator
  }
}

TEST_CASE("every sampling can be cancelled, and tells of its work often enough") {
  const Mesh mesh = test::make_sphere(1);
  for (const Sampling kind : {Sampling::farthest, Sampling::random, Sampling::poisson}) {
    CAPTURE(int(kind));
    constexpr int kCount = 1280;
    const auto calls = test::require_cancelled_everywhere([&](const Progress& progress) {
      SamplingOptions options;
      options.kind = kind;
      options.count = kCount;
      options.progress = progress;
      sample_generators(mesh, options);
    });
    CHECK(calls.at("sampling") >= kCount / 64);
    if (kind == Sampling::farthest) CHECK(calls.at("splitting edges") >= (kCount - mesh.vertex_count()) / 64);
  }
}

TEST_CASE("random points that are compared with each other tell of that, too") {
  constexpr int kCount = 1 << 15;
  int calls = 0;
  SamplingOptions options;
  options.kind = Sampling::random;
  options.count = kCount;
  options.progress = [&](std::string_view, double) { return ++calls > 0; };
  sample_generators(test::make_sphere(1), options);
  CHECK(calls > kCount / 64 + kCount / 4096);
}

}  // namespace gvd::test_sampling
