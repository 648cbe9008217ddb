// Lloyd's relaxation as a library: energies, centroids, and what must never happen.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "gvd/check.hpp"
#include "gvd/error.hpp"
#include "gvd/lloyd.hpp"
#include "gvd/sampling.hpp"
#include "lloyd/states.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_lloyd {

/// The point of a grid of unit squares at a position.
SurfacePoint grid_point(const Mesh& mesh, double x, double y) {
  for (int f = 0; f < mesh.face_count(); ++f) {
    const auto& [a, b, c] = mesh.vertices(FaceId(f));
    const Vec3& pa = mesh.position(a);
    const Vec3 u = mesh.position(b) - pa, v = mesh.position(c) - pa, w = Vec3(x, y, 0) - pa;
    const double area = u.cross(v).z(), s = w.cross(v).z() / area, t = u.cross(w).z() / area;
    if (s >= -1e-12 && t >= -1e-12 && s + t <= 1 + 1e-12) return make_surface_point(FaceId(f), {1 - s - t, s, t});
  }
  return {};
}

void require_falling(const LloydResult& result) {
  double energy = result.initial_energy;
  for (const LloydIteration& i : result.iterations) {
    REQUIRE(i.energy <= energy);
    REQUIRE(i.largest_move >= i.mean_move);
    energy = i.energy;
  }
  REQUIRE(result.final_energy == energy);
}

TEST_CASE("lloyd: the moments of a rectangle about any of its points are exact") {
  const Mesh mesh = test::make_grid(6, 4);
  for (const auto& [x, y] : {std::pair(3.0, 2.0), std::pair(1.3, 0.9), std::pair(0.0, 4.0), std::pair(2.5, 2.5)}) {
    const Diagram diagram = compute_diagram(mesh, {grid_point(mesh, x, y)});
    const CellMoments m = compute_cell_moments(mesh, diagram)[GeneratorId(0)];
    CHECK(m.area == Approx(24));
    CHECK(m.centroid.norm() == Approx(std::hypot(3 - x, 2 - y)).margin(1e-9));
    const auto second = [](double low, double high) { return (std::pow(high, 3) - std::pow(low, 3)) / 3; };
    CHECK(m.energy == Approx(4 * second(-x, 6 - x) + 6 * second(-y, 4 - y)).epsilon(1e-9));
  }
}

TEST_CASE("lloyd: on a surface without area, generators are not moved to one place") {
  const Mesh mesh =
      test::make_mesh({{0.8, 0.6, 0},
                       {4.898587196589413e-17, 3.6739403974420595e-17, 0},
                       {-0.8, -0.6, 0},
                       {-1.4695761589768238e-16, -1.1021821192326178e-16, 0},
                       {0, 0, 0},
                       {0, 0, 0}},
                      {{0, 1, 4}, {1, 0, 5}, {1, 2, 4}, {2, 1, 5}, {2, 3, 4}, {3, 2, 5}, {3, 0, 4}, {0, 3, 5}});
  std::vector<SurfacePoint> generators;
  for (const int f : {0, 2, 4, 6}) generators.push_back(make_surface_point(FaceId(f), {1.0 / 3, 1.0 / 3, 1.0 / 3}));
  LloydOptions options;
  options.max_iterations = 2;
  CHECK_NOTHROW(relax_generators(mesh, generators, options));
}

TEST_CASE("lloyd: relaxation of many more generators than faces") {
  const Mesh mesh = test::make_tetrahedron();
  SamplingOptions sampling;
  sampling.count = 200;
  LloydOptions options;
  options.max_iterations = 3;
  const LloydResult result = relax_generators(mesh, sample_generators(mesh, sampling), options);
  CHECK(result.iterations.size() == 3);
  CHECK(result.final_energy < 0.99 * result.initial_energy);
}

TEST_CASE("lloyd: one generator goes to the centre of its square in one step") {
  const Mesh mesh = test::make_grid(8, 8);
  const LloydResult result = relax_generators(mesh, {grid_point(mesh, 1.2, 2.7)});
  REQUIRE(result.iterations.size() == 1);
  CHECK(result.stop == LloydStop::centroids);
  CHECK((position(mesh, result.generators[0]) - Vec3(4, 4, 0)).norm() < 1e-8);  // angles of departure are rounded
}

TEST_CASE("lloyd: four generators of a square go to the centres of its quarters") {
  const Mesh mesh = test::make_grid(12, 12);
  LloydOptions options;
  options.energy_tolerance = 0;
  options.move_tolerance = 1e-4;
  options.max_iterations = 400;
  const std::vector<SurfacePoint> start{grid_point(mesh, 2.3, 3.1), grid_point(mesh, 8.4, 2.2),
                                        grid_point(mesh, 3.6, 9.7), grid_point(mesh, 10.1, 8.3)};
  const LloydResult result = relax_generators(mesh, start, options);
  require_falling(result);
  CHECK(result.final_energy == Approx(4 * (6 * 6 * 6 * 6) / 6.0).epsilon(1e-5));
  const std::vector<Vec3> centres{{3, 3, 0}, {9, 3, 0}, {3, 9, 0}, {9, 9, 0}};
  for (std::size_t i = 0; i < 4; ++i) CHECK((position(mesh, result.generators[i]) - centres[i]).norm() < 0.01);
}

TEST_CASE("lloyd: energies fall, and generators stay on the surface, apart, and in a sound diagram") {
  for (const auto& [name, mesh] : test::small_family()) {
    for (const int count : {1, 2, 5, 30}) {
      for (unsigned seed = 0; seed < 3; ++seed) {
        CAPTURE(name, count, seed);
        LloydOptions options;
        options.max_iterations = 12;
        const LloydResult result = relax_generators(mesh, test::random_generators(mesh, count, seed), options);
        require_falling(result);
        REQUIRE(result.generators.size() == static_cast<std::size_t>(count));
        for (const SurfacePoint& p : result.generators) {
          REQUIRE((p.face.valid() && p.face.value() < mesh.face_count()));
          REQUIRE(p.kind() == make_surface_point(p.face, p.bary).kind());
        }
        REQUIRE(check_diagram(mesh, result.diagram).ok());
        if (count == 30) REQUIRE(result.final_energy < 0.9 * result.initial_energy);
      }
    }
  }
}

TEST_CASE("lloyd: each acceleration lowers the energy, names its steps, and gives the same bytes twice") {
  for (const auto& [name, mesh] : test::small_family()) {
    for (const Acceleration acceleration : {Acceleration::none, Acceleration::lbfgs}) {
      CAPTURE(name, static_cast<int>(acceleration));
      LloydOptions options;
      options.acceleration = acceleration;
      options.max_iterations = 10;
      const auto start = test::random_generators(mesh, 12, 4);
      const LloydResult first = relax_generators(mesh, start, options), again = relax_generators(mesh, start, options);
      require_falling(first);
      CHECK(first.generators == again.generators);
      CHECK(first.final_energy == again.final_energy);
      for (const LloydIteration& i : first.iterations) {
        REQUIRE((i.by == acceleration || i.by == Acceleration::none));
      }
    }
  }
}

TEST_CASE("lloyd: L-BFGS takes less than half of the iterations of Lloyd's method to its energy") {
  for (const unsigned seed : {1u, 2u, 3u}) {
    CAPTURE(seed);
    const Mesh mesh = test::make_bumpy_sphere(3, seed);
    SamplingOptions sampling;
    sampling.count = 40;
    const auto start = sample_generators(mesh, sampling);
    LloydOptions options;
    options.acceleration = Acceleration::none;
    options.max_iterations = 40;
    options.energy_tolerance = 0;
    const double reached = relax_generators(mesh, start, options).final_energy;
    options.acceleration = Acceleration::lbfgs;
    options.max_iterations = 20;
    CHECK(relax_generators(mesh, start, options).final_energy <= reached);
  }
}

TEST_CASE("lloyd: both fronts, and the same bytes twice") {
  const Mesh mesh = test::make_bumpy_sphere(3, 7);
  const auto start = test::random_generators(mesh, 20, 5);
  for (const Front front : {Front::circle, Front::planar}) {
    LloydOptions options;
    options.diagram.method = Method::gbgvd;
    options.diagram.front = front;
    options.max_iterations = 8;
    const LloydResult first = relax_generators(mesh, start, options), again = relax_generators(mesh, start, options);
    require_falling(first);
    CHECK(first.generators == again.generators);
    CHECK(first.final_energy == again.final_energy);
  }
}

TEST_CASE("lloyd: generators that start close together move apart") {
  const Mesh mesh = test::make_sphere(3);
  std::vector<SurfacePoint> start;
  for (int i = 0; i < 6; ++i) start.push_back(make_surface_point(FaceId(17), {0.3 + 1e-5 * i, 0.3, 0.4 - 1e-5 * i}));
  LloydOptions options;
  options.max_iterations = 200;
  options.energy_tolerance = 1e-7;
  const LloydResult result = relax_generators(mesh, start, options);
  require_falling(result);
  double nearest = 10;
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      nearest = std::min(nearest, (position(mesh, result.generators[i]) - position(mesh, result.generators[k])).norm());
    }
  }
  CHECK(nearest > 0.8);  // an octahedron's corners are 1.41 apart
}

TEST_CASE("lloyd: a generator just beside a saddle reaches it by a step of a hundredth") {
  // Most of the disc lies behind the saddle, so the step points at it and leads far beyond. There are two full turns
  // too many about the saddle: whatever is passed comes nearer to one side and farther from all others.
  std::vector<Vec3> positions = {{0, 0, 0}};
  std::vector<std::array<int, 3>> faces;
  const int sides = 12;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    positions.push_back({std::cos(angle), std::sin(angle), i % 2 == 0 ? 2.0 : -2.0});
    faces.push_back({0, 1 + i, 1 + (i + 1) % sides});
  }
  const Mesh mesh = test::make_mesh(positions, faces);
  const double beside = 0.003;
  const LloydResult result = relax_generators(mesh, {make_surface_point(FaceId(0), {1 - 2 * beside, beside, beside})});
  require_falling(result);
  CHECK(result.final_energy < result.initial_energy);
  CHECK(position(mesh, result.generators[0]).norm() < 0.1 * beside);
}

TEST_CASE("lloyd: generators of a ring end half way between its boundaries") {
  const Mesh mesh = test::make_ring(24, 6);
  for (unsigned seed = 0; seed < 4; ++seed) {
    const LloydResult result = relax_generators(mesh, test::random_generators(mesh, 3, seed));
    require_falling(result);
    for (const SurfacePoint& p : result.generators) CHECK(position(mesh, p).z() == Approx(0.25).margin(0.02));
  }
}

TEST_CASE("lloyd: a run whose time is over ends with an exact diagram of its last generators") {
  const Mesh mesh = test::make_sphere(3);
  const auto start = test::random_generators(mesh, 8, 1);
  LloydOptions options;
  options.energy_tolerance = 0;
  options.move_tolerance = 0;
  for (const int allowed : {0, 1, 4}) {
    CAPTURE(allowed);
    int asked = 0;
    options.is_time_over = [&] { return asked++ == allowed; };
    const LloydResult result = relax_generators(mesh, start, options);
    CHECK(result.stop == LloydStop::time_limit);
    CHECK(std::ssize(result.iterations) <= allowed);
    CHECK((result.generators == start) == (allowed == 0));
    require_falling(result);
    const Diagram exact = compute_diagram(mesh, result.generators);
    CHECK(result.diagram.vertex_distance == exact.vertex_distance);
    CHECK(result.diagram.length == exact.length);
  }
}

TEST_CASE("lloyd: zero iterations are allowed, and options out of range are refused") {
  const Mesh mesh = test::make_sphere(2);
  const auto start = test::random_generators(mesh, 5, 1);
  LloydOptions options;
  options.max_iterations = 0;
  const LloydResult result = relax_generators(mesh, start, options);
  CHECK(result.stop == LloydStop::max_iterations);
  CHECK(result.generators == start);
  CHECK(result.final_energy == result.initial_energy);
  const auto refused = [&](auto change) {
    LloydOptions bad;
    change(bad);
    CHECK_THROWS_AS(relax_generators(mesh, start, bad), Error);
  };
  refused([](LloydOptions& o) { o.max_iterations = -1; });
  refused([](LloydOptions& o) { o.energy_tolerance = -1; });
  refused([](LloydOptions& o) { o.move_tolerance = std::nan(""); });
}

TEST_CASE("lloyd: options of the diagram are refused before the first step") {
  const Mesh mesh = test::make_sphere(2);
  const auto start = test::random_generators(mesh, 5, 1);
  const auto refused = [&](auto change) {
    LloydOptions bad;
    bad.on_iteration = [](std::int64_t, double, const std::vector<SurfacePoint>&) { FAIL("began"); };
    change(bad.diagram);
    CHECK_THROWS_AS(relax_generators(mesh, start, bad), Error);
  };
  refused([](DiagramOptions& o) { o.chord_tolerance = -1; });
  refused([](DiagramOptions& o) { o.chord_tolerance = std::nan(""); });
  refused([](DiagramOptions& o) { o.threads = -1; });
}

TEST_CASE("lloyd: no generators, and an energy that is no number, are refused") {
  const Mesh mesh = test::make_tetrahedron();
  CHECK_THROWS_AS(relax_generators(mesh, {}, {}), Error);
  LloydOptions options;
  options.density = make_face_density(mesh, {1e308, 1e308, 1e308, 1e308});
  CHECK_THROWS_AS(relax_generators(test::scaled(mesh, 1e3), {vertex_point(mesh, VertexId(0))}, options), Error);
}

TEST_CASE("lloyd: generators on vertices move on surfaces of any size") {
  const Mesh mesh = test::make_sphere(2);
  const std::vector<SurfacePoint> start = {vertex_point(mesh, VertexId(0)), vertex_point(mesh, VertexId(1)),
                                           vertex_point(mesh, VertexId(2))};
  LloydOptions options;
  options.max_iterations = 5;
  const LloydResult unscaled = relax_generators(mesh, start, options);
  REQUIRE(unscaled.final_energy < 0.9 * unscaled.initial_energy);
  for (const int power : {-60, -240, 60, 240}) {
    CAPTURE(power);
    const LloydResult result = relax_generators(test::scaled(mesh, std::ldexp(1, power)), start, options);
    CHECK(std::ldexp(result.initial_energy, -4 * power) == Approx(unscaled.initial_energy));
    CHECK(std::ldexp(result.final_energy, -4 * power) == Approx(unscaled.final_energy));
  }
}

TEST_CASE("lloyd: each iteration is told with its energy, the start too, and again when it is measured anew") {
  const Mesh mesh = test::make_sphere(2);
  for (const bool early : {false, true}) {
    CAPTURE(early);
    LloydOptions options;
    options.max_iterations = 5;
    std::vector<double> energies;
    options.on_iteration = [&](std::int64_t iterations, double energy, const std::vector<SurfacePoint>&) {
      CHECK((iterations == std::ssize(energies) || (early && iterations < std::ssize(energies))));
      energies.resize(static_cast<std::size_t>(iterations) + 1);
      energies.back() = energy;
    };
    const auto start = test::random_generators(mesh, 5, 1);
    const LloydResult result = relax_generators(mesh, start, options, {.early_approximation = early});
    REQUIRE(energies.size() == result.iterations.size() + 1);
    CHECK(energies.front() == result.initial_energy);
    CHECK(energies.back() == result.final_energy);
  }
}

TEST_CASE("lloyd: cancelling throws") {
  const Mesh mesh = test::make_sphere(2);
  LloydOptions options;
  int calls = 0;
  options.progress = [&](std::string_view, double fraction) {
    CHECK((fraction >= 0 && fraction <= 1));
    return ++calls < 5;
  };
  CHECK_THROWS_AS(relax_generators(mesh, test::random_generators(mesh, 5, 1), options), Error);
  CHECK(calls == 5);
}

TEST_CASE("lloyd: a relaxation that ends by its tolerance has told so before") {
  const Mesh mesh = test::make_bumpy_sphere(3, 2);
  struct End {
    std::optional<double> energy_tolerance;
    double move_tolerance;
    LloydStop stop;
  };
  for (const auto& [energy, move, stop] : {End{1e-6, 0, LloydStop::energy},
                                           {1e-8, 0.01, LloydStop::centroids},
                                           {std::nullopt, 0, LloydStop::prediction}}) {
    LloydOptions options;
    options.energy_tolerance = energy;
    options.move_tolerance = move;
    double last = 0;
    options.progress = [&](std::string_view, double fraction) {
      last = fraction;
      return true;
    };
    const LloydResult result = relax_generators(mesh, test::random_generators(mesh, 20, 1), options);
    REQUIRE(result.stop == stop);
    CHECK(std::ssize(result.iterations) < max_iterations(options) / 2);
    CHECK(last > 0.7);
  }
}

TEST_CASE("lloyd: by default it ends where hardly anything is left, within 0.5 % of the limit") {
  for (const int count : {20, 60, 150}) {
    for (unsigned seed = 0; seed < 3; ++seed) {
      for (const Mesh& mesh : {test::make_bumpy_sphere(4, seed), test::make_sphere(4), test::make_grid(30, 30)}) {
        CAPTURE(count, seed, mesh.face_count());
        const LloydResult result = relax_generators(mesh, test::random_generators(mesh, count, seed));
        CHECK((result.stop == LloydStop::prediction || result.stop == LloydStop::centroids));
        LloydOptions to_the_limit;
        to_the_limit.energy_tolerance = 1e-8;
        const LloydResult limit = relax_generators(mesh, result.generators, to_the_limit);
        CHECK(limit.stop != LloydStop::no_descent);
        CHECK(result.final_energy < 1.005 * limit.final_energy);
      }
    }
  }
}

TEST_CASE("lloyd: from its own result it ends at once") {
  const Mesh mesh = test::make_bumpy_sphere(4, 1);
  const LloydResult first = relax_generators(mesh, test::random_generators(mesh, 50, 2));
  const LloydResult again = relax_generators(mesh, first.generators);
  CHECK(again.iterations.size() <= 2);
  CHECK(again.final_energy <= first.final_energy);
}

TEST_CASE("lloyd: near the end the ways to the centroids fall quickly, without Lloyd's steps") {
  for (const Mesh& mesh : {test::make_sphere(4), test::make_grid(24, 24)}) {
    for (unsigned seed = 0; seed < 4; ++seed) {
      CAPTURE(mesh.face_count(), seed);
      LloydOptions options;
      options.energy_tolerance = 0;
      std::vector<std::vector<SurfacePoint>> passed;
      options.on_iteration = [&](std::int64_t, double, const std::vector<SurfacePoint>& points) {
        if (passed.empty() || points != passed.back()) passed.push_back(points);
      };
      const LloydResult result = relax_generators(mesh, test::random_generators(mesh, 24, seed), options);
      REQUIRE(result.stop == LloydStop::centroids);
      CHECK(std::ranges::all_of(
          result.iterations, [](const LloydIteration& i) { return i.relocated > 0 || i.by == Acceleration::lbfgs; }));
      std::vector<double> residuals;
      for (auto points = passed.end() - std::min<std::ptrdiff_t>(5, std::ssize(passed)); points != passed.end();
           ++points) {
        residuals.push_back(test::evaluate_state(mesh, *points).residual);
      }
      INFO(Catch::StringMaker<std::vector<double>>::convert(residuals));
      // Steps along valleys lower the energy while they lengthen other ways.
      CHECK(residuals.back() < 0.3 * *std::ranges::max_element(residuals));
    }
  }
}

}  // namespace gvd::test_lloyd
