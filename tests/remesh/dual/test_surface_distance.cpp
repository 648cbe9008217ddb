// Distances of surfaces that are known, in both directions, and samples of them.
#include <cmath>
#include <numbers>
#include <utility>

#include "gvd/closest_point.hpp"
#include "gvd/error.hpp"
#include "gvd/surface_distance.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/random.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_surface_distance {

/// The largest distance, and the mean square, of the centres of k * k equal parts of each face.
SurfaceDistance sample_densely(const Mesh& from, const Mesh& to, int k) {
  const ClosestPointTree tree(to);
  SurfaceDistance result;
  double area = 0, sum = 0;
  for (std::int32_t f = 0; f < from.face_count(); ++f) {
    const auto& [a, b, c] = from.vertices(FaceId(f));
    for (int i = 0; i < k; ++i) {
      for (int j = 0; i + j < k; ++j) {
        const double s = (i + 1.0 / 3) / k, t = (j + 1.0 / 3) / k;
        const Vec3 p = s * from.position(a) + t * from.position(b) + (1 - s - t) * from.position(c);
        const double d = tree.query(p).distance, weight = from.area(FaceId(f));
        result.hausdorff = std::max(result.hausdorff, d);
        sum += weight * d * d;
        area += weight;
      }
    }
  }
  result.rms = std::sqrt(sum / area);
  return result;
}

Mesh square_at(double x, double y, double z, double size) {
  return test::make_mesh({{x, y, z}, {x + size, y, z}, {x + size, y + size, z}, {x, y + size, z}},
                         {{0, 1, 2}, {0, 2, 3}});
}

TEST_CASE("a mesh has no distance from itself, and a shifted plane has the shift") {
  const Mesh sphere = test::make_sphere(3);
  const SurfaceDistance none = measure_surface_distance(sphere, sphere);
  CHECK(none.hausdorff < 1e-15);
  CHECK(none.hausdorff_bound <= kLeastHausdorffTolerance * sphere.bbox_diagonal());
  CHECK(none.rms < 1e-15);
  const SurfaceDistance shift = measure_surface_distance(square_at(0, 0, 0.25, 1), square_at(-1, -1, 0, 3));
  CHECK(shift.hausdorff == Approx(0.25));
  CHECK(shift.hausdorff_bound == Approx(0.25));
  CHECK(shift.rms == Approx(0.25));
}

TEST_CASE("the two directions differ: a part of a square has no distance from it, and it has one from the part") {
  const Mesh part = square_at(0, 0, 0, 1), whole = square_at(0, 0, 0, 2);
  CHECK(measure_surface_distance(part, whole).hausdorff < 1e-15);
  const SurfaceDistance back = measure_surface_distance(whole, part);
  CHECK(back.hausdorff == Approx(std::sqrt(2)));
  CHECK(back.hausdorff_bound <= 1.01 * std::sqrt(2));
  // A fourth of the square has no distance. Two have x^2, with the mean 1/3, and one x^2 + y^2.
  CHECK(back.rms == Approx(std::sqrt((1.0 / 3 + 1.0 / 3 + 2.0 / 3) / 4)).epsilon(1e-4));
}

TEST_CASE("a bump between the samples is found") {
  // The square's distance from a tent is largest at one point inside a face.
  const Vec3 top(0.37, 0.21, 0.001);
  const Mesh tent =
      test::make_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, top}, {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
  const Mesh square = square_at(0, 0, 0, 1);
  CHECK(measure_surface_distance(tent, square).hausdorff == Approx(top.z()));
  const SurfaceDistance found = measure_surface_distance(square, tent);
  CHECK(found.hausdorff <= top.z());
  CHECK(found.hausdorff_bound >= (1 - 1e-5) * top.z());
  CHECK(found.hausdorff_bound <= found.hausdorff + std::max(0.01 * found.hausdorff, 1.5e-6));
}

TEST_CASE("distances agree with a dense sampling, for any number of threads") {
  for (const unsigned seed : {1U, 2U}) {
    const Mesh coarse = test::make_bumpy_sphere(1, seed), fine = test::make_bumpy_sphere(4, seed);
    for (const auto& [from, to, k] : {std::tuple(&coarse, &fine, 60), std::tuple(&fine, &coarse, 4)}) {
      const SurfaceDistance measured = measure_surface_distance(*from, *to, 1), dense = sample_densely(*from, *to, k);
      CHECK(measured.rms == Approx(dense.rms).epsilon(0.01));
      CHECK(measured.hausdorff_bound >= dense.hausdorff);
      CHECK(measured.hausdorff_bound <= 1.01 * measured.hausdorff);
      CHECK(dense.hausdorff >= 0.97 * measured.hausdorff);
      const SurfaceDistance again = measure_surface_distance(*from, *to, 3);
      CHECK(again.rms == measured.rms);
      CHECK(again.hausdorff == measured.hausdorff);
      CHECK(again.hausdorff_bound == measured.hausdorff_bound);
    }
  }
}

TEST_CASE("flat surfaces that agree have a small bound, whatever their edges are") {
  const Mesh grid = test::make_grid(6, 6);
  const Mesh two = test::make_mesh({{0, 0, 0}, {6, 0, 0}, {6, 6, 0}, {0, 6, 0}}, {{0, 1, 3}, {1, 2, 3}});
  const Mesh four = test::make_mesh({{0, 0, 0}, {6, 0, 0}, {6, 6, 0}, {0, 6, 0}, {2.1, 3.7, 0}},
                                    {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
  for (const auto& [from, to] : {std::pair(&grid, &two), {&grid, &four}, {&two, &four}, {&four, &grid}}) {
    CHECK(measure_surface_distance(*from, *to).hausdorff_bound <= 2e-6 * grid.bbox_diagonal());
  }
}

TEST_CASE("the bound holds over folds, however sharp and wherever their edge ends") {
  test::Random random(3);
  for (int i = 0; i < 200; ++i) {
    const auto point = [&] { return Vec3(random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)); };
    const Mesh fold = test::make_mesh({point(), point(), point(), point()}, {{0, 1, 2}, {1, 0, 3}});
    const Mesh from = test::make_mesh({point(), point(), point()}, {{0, 1, 2}});
    const SurfaceDistance found = measure_surface_distance(from, fold);
    CHECK(sample_densely(from, fold, 60).hausdorff <= found.hausdorff_bound * (1 + 1e-12));
    CHECK(found.hausdorff_bound <= found.hausdorff * (1 + kHausdorffTolerance) * (1 + 1e-12));
  }
}

/// A fan of faces round (0, 0, 0): `count` of the `of` sectors of the whole turn. The rim is up to `height` high.
Mesh random_fan(test::Random& random, int count, int of, double height) {
  std::vector<Vec3> positions{{0, 0, 0}};
  std::vector<std::array<int, 3>> faces;
  for (int i = 0; i < std::min(count + 1, of); ++i) {
    const double angle = 2 * std::numbers::pi * (i + random.real(-0.3, 0.3)) / of, radius = random.real(0.5, 1);
    positions.emplace_back(radius * std::cos(angle), radius * std::sin(angle), random.real(-height, height));
  }
  for (int i = 0; i < count; ++i) faces.push_back({0, 1 + i, 1 + (i + 1) % of});
  return test::make_mesh(positions, faces);
}

TEST_CASE("the bound holds round a vertex, where its faces are flat, nearly flat or steep") {
  test::Random random(5);
  for (int i = 0; i < 200; ++i) {
    const int of = 5 + random.below(3), count = i % 2 ? of : 2 + random.below(of - 2);
    const Mesh fan = random_fan(random, count, of, std::array{0.0, 1e-4, 0.05, 1.0}[i % 4]);
    const auto point = [&] { return Vec3(random.real(-0.2, 0.2), random.real(-0.2, 0.2), random.real(-1e-3, 1e-3)); };
    const Mesh from = test::make_mesh({point(), point(), point()}, {{0, 1, 2}});
    const SurfaceDistance found = measure_surface_distance(from, fan);
    CHECK(sample_densely(from, fan, 60).hausdorff <= found.hausdorff_bound * (1 + 1e-12));
    CHECK(found.hausdorff_bound <= found.hausdorff * (1 + kHausdorffTolerance) + 2e-6 * fan.bbox_diagonal());
  }
}

/// Needles as long as `length` and .001 wide, side by side, `count` pairs of them, in the plane z = 0.
Mesh make_needles(int count, double length) {
  const Mesh grid = test::make_grid(count, 1);
  std::vector<Vec3> positions = grid.positions();
  for (Vec3& p : positions) p = {0.001 * p.x(), length * p.y(), 0};
  return {std::move(positions), grid.face_vertices()};
}

TEST_CASE("needles that cross many faces have a bound close to the distance") {
  const Mesh needles = make_needles(200, 80), grid = test::make_grid(1, 160);
  std::vector<Vec3> positions = grid.positions();
  for (Vec3& p : positions) p = {p.x(), p.y() / 2, 0.004 * p.y() * std::sin(2 * p.y())};
  const SurfaceDistance found = measure_surface_distance(needles, {std::move(positions), grid.face_vertices()});
  CHECK(found.hausdorff > 0.2);
  CHECK(found.hausdorff_bound <= (1 + kHausdorffTolerance) * found.hausdorff * (1 + 1e-12));
}

TEST_CASE("the bound holds for needles, whose longest side is searched in their place") {
  test::Random random(7);
  for (int i = 0; i < 100; ++i) {
    const auto point = [&] { return Vec3(random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)); };
    const Mesh fold = test::make_mesh({point(), point(), point(), point()}, {{0, 1, 2}, {1, 0, 3}});
    const Vec3 a = point(), b = point(), c = a + random.real(0, 1) * (b - a) + 0.002 * point();
    const Mesh needle = test::make_mesh({a, b, c}, {{0, 1, 2}});
    const SurfaceDistance found = measure_surface_distance(needle, fold);
    CHECK(sample_densely(needle, fold, 100).hausdorff <= found.hausdorff_bound * (1 + 1e-12));
    CHECK(found.hausdorff_bound <= found.hausdorff * (1 + kHausdorffTolerance) * (1 + 1e-12));
  }
}

TEST_CASE("an n-gon that is a fan of needles is measured against a coarse one") {
  const auto make_fan = [](int corners) {
    std::vector<Vec3> positions;
    std::vector<std::array<int, 3>> faces;
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * std::numbers::pi * i / corners;
      positions.emplace_back(std::cos(angle), std::sin(angle), 0);
      if (i >= 2) faces.push_back({0, i - 1, i});
    }
    return test::make_mesh(positions, faces);
  };
  const Mesh fine = make_fan(1200), coarse = make_fan(30);
  const double sagitta = 1 - std::cos(std::numbers::pi / 30);
  const SurfaceDistance there = measure_surface_distance(fine, coarse), back = measure_surface_distance(coarse, fine);
  CHECK(there.hausdorff == Approx(sagitta).epsilon(0.01));
  CHECK(there.hausdorff_bound >= sagitta * (1 - 1e-6));
  CHECK(there.hausdorff_bound <= 1.01 * sagitta);
  CHECK(back.hausdorff < 1e-8);  // rounding, in needles with angles of .0026
  CHECK(back.hausdorff_bound <= 1.01e-6 * fine.bbox_diagonal());
}

TEST_CASE("where the search ends at its limit, the bound holds and exceeds the distance by more") {
  // Triangles without neighbours: over a gap between two of them, only pieces as small as their height are bounded
  // well.
  const Mesh grid = test::make_grid(12, 12);
  std::vector<Vec3> corners;
  std::vector<std::array<int, 3>> faces;
  for (std::int32_t f = 0; f < grid.face_count(); ++f) {
    for (const VertexId v : grid.vertices(FaceId(f))) corners.push_back(grid.position(v));
    faces.push_back({3 * f, 3 * f + 1, 3 * f + 2});
  }
  const SurfaceDistance found = measure_surface_distance(square_at(0, 0, 2e-4, 12), test::make_mesh(corners, faces));
  CHECK(found.hausdorff == Approx(2e-4));
  CHECK(found.hausdorff_bound > 1.2 * found.hausdorff);
  CHECK(found.hausdorff_bound < 0.1);
}

TEST_CASE("a triangle without area has the distances of its points") {
  const Mesh line({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{VertexId(0), VertexId(1), VertexId(2)}});
  const Mesh square = test::make_grid(1, 1);
  const SurfaceDistance distance = measure_surface_distance(line, square);
  CHECK(distance.hausdorff == Approx(1));
  CHECK(distance.hausdorff_bound >= distance.hausdorff);
  CHECK(distance.rms == 0);
}

TEST_CASE("a mesh without faces has no distance") {
  CHECK_THROWS_AS(measure_surface_distance(Mesh(), test::make_tetrahedron()), Error);
  CHECK_THROWS_AS(measure_surface_distance(test::make_tetrahedron(), Mesh()), Error);
}

std::size_t lattice_size(const DistanceSamples& samples) {
  std::int64_t size = 0;
  for (const std::int32_t k : samples.steps) size += DistanceSamples::lattice_size(k);
  return static_cast<std::size_t>(size);
}

TEST_CASE("samples at vertices and on lattices are distances of their points") {
  const Mesh coarse = test::make_bumpy_sphere(1, 3), fine = test::make_bumpy_sphere(3, 3);
  const DistanceSamples samples = sample_surface_distance(coarse, fine);
  const ClosestPointTree tree(fine);
  for (std::int32_t i = 0; i < coarse.vertex_count(); ++i) {
    REQUIRE(samples.at_vertex[VertexId(i)] == Approx(tree.query(coarse.position(VertexId(i))).distance).margin(1e-12));
  }
  std::size_t next = 0;
  for (std::int32_t f = 0; f < coarse.face_count(); ++f) {
    const auto& [a, b, c] = coarse.vertices(FaceId(f));
    const std::int32_t k = samples.steps[FaceId(f)];
    REQUIRE(k > 8);
    for (std::int32_t i = 0; i <= k; ++i) {
      for (std::int32_t j = 0; j <= k - i; ++j, ++next) {
        if ((i + j) % 5 != 0) continue;
        const Vec3 point = (i * coarse.position(a) + (k - i - j) * coarse.position(b) + j * coarse.position(c)) / k;
        REQUIRE(samples.lattice[next] == Approx(tree.query(point).distance).margin(1e-12));
      }
    }
  }
  CHECK(next == samples.lattice.size());
}

TEST_CASE("samples are denser in large faces, and bounded in number") {
  // Two faces: one with almost all of the area, one with 1 / 40000 of it.
  const Mesh kite = test::make_mesh({{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, -0.00003, 0}}, {{0, 1, 2}, {0, 3, 1}});
  const DistanceSamples uneven = sample_surface_distance(kite, kite);
  CHECK(uneven.steps[FaceId(0)] == DistanceSamples::kMaxSteps);
  CHECK(uneven.steps[FaceId(1)] == 1);
  CHECK(uneven.lattice.size() == lattice_size(uneven));
  for (const int n : {4, 5, 6}) {
    const Mesh sphere = test::make_sphere(n);
    const DistanceSamples samples = sample_surface_distance(sphere, kite, 2);
    CHECK(samples.lattice.size() == lattice_size(samples));
    CHECK(double(samples.lattice.size()) <= 1.5 * kSampledTriangles);
    CHECK(samples.at_vertex.size() == static_cast<std::size_t>(sphere.vertex_count()));
    if (n == 6) CHECK(samples.lattice.empty());
    if (n == 4) CHECK(samples.lattice == sample_surface_distance(sphere, kite, 1).lattice);
  }
}

TEST_CASE("a mesh without faces has no samples of distances") {
  CHECK_THROWS_AS(sample_surface_distance(Mesh(), test::make_tetrahedron()), Error);
  CHECK_THROWS_AS(sample_surface_distance(test::make_tetrahedron(), Mesh()), Error);
}

}  // namespace gvd::test_surface_distance
