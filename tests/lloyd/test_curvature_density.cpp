// The curvature density: its sizes on spheres, by range and gradation, and what must not change them.
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "gvd/density.hpp"
#include "gvd/error.hpp"
#include "gvd/sampling.hpp"
#include "support/cancelled.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/random.hpp"

namespace gvd::test_curvature_density {

/// Sizes of the cells at the vertices, in units of the even spacing.
std::vector<double> sizes_at_vertices(const Mesh& mesh, int count, const CurvatureDensityOptions& options = {}) {
  const Density density = make_curvature_density(mesh, count, options);
  std::vector<double> sizes(static_cast<std::size_t>(mesh.vertex_count()));
  for (const FaceId f : mesh.faces()) {
    for (std::size_t i = 0; i < 3; ++i) sizes[mesh.vertices(f)[i].index()] = std::pow(density.corners[f][i], -0.25);
  }
  return sizes;
}

template <class Move>
Mesh moved(const Mesh& mesh, Move move) {
  std::vector<Vec3> positions;
  for (const Vec3& p : mesh.positions()) positions.push_back(move(p));
  return Mesh(std::move(positions), mesh.face_vertices());
}

Mesh flattened_sphere() {
  return moved(test::make_sphere(4), [](const Vec3& p) { return Vec3(p.x(), p.y(), p.z() / 4); });
}

double largest_ratio(const std::vector<double>& a, const std::vector<double>& b) {
  double ratio = 1;
  for (std::size_t i = 0; i < a.size(); ++i) ratio = std::max({ratio, a[i] / b[i], b[i] / a[i]});
  return ratio;
}

TEST_CASE("curvature density: it is 1 on a plane, also a slanting one, and nearly 1 on a sphere") {
  const Mesh grid = test::make_grid(6, 5);
  const Mesh slanting = moved(grid, [](const Vec3& p) { return Vec3(p.x() / 3 + 7, p.y() - p.x(), 0.7 * p.y()); });
  for (const Mesh& plane : {grid, slanting}) {
    for (const double size : sizes_at_vertices(plane, 20)) CHECK(size == Approx(1).epsilon(1e-9));
  }
  for (const double size : sizes_at_vertices(test::make_sphere(4), 100)) CHECK(size == Approx(1).epsilon(0.05));
}

TEST_CASE("curvature density: sizes go with the cube root of the radius of spheres") {
  std::vector<Vec3> positions;
  std::vector<std::array<VertexId, 3>> faces;
  const Mesh sphere = test::make_sphere(4);
  for (const double radius : {1.0, 0.3}) {
    const auto first = static_cast<std::int32_t>(positions.size());
    for (const Vec3& p : sphere.positions()) positions.emplace_back(radius * p);
    for (const auto& [a, b, c] : sphere.face_vertices()) {
      faces.push_back({VertexId(first + a.value()), VertexId(first + b.value()), VertexId(first + c.value())});
    }
  }
  const std::vector<double> sizes = sizes_at_vertices(Mesh(positions, faces), 500);
  // The discs, with a third of the small sphere's radius, see its curvature a little too small.
  CHECK(sizes.front() / sizes.back() == Approx(std::cbrt(1 / 0.3)).epsilon(0.05));
}

TEST_CASE("curvature density: sizes keep to their range and their gradation, and give the number of cells") {
  for (const test::NamedMesh& named : test::small_family()) {
    INFO(named.name);
    const Mesh& mesh = named.mesh;
    const double spacing = even_spacing(compute_area(mesh), 40);
    const CurvatureDensityOptions options{0.5, 4, {}};
    const std::vector<double> sizes = sizes_at_vertices(mesh, 40, options);
    const auto [least, most] = std::minmax_element(sizes.begin(), sizes.end());
    CHECK(*most / *least <= options.range * (1 + 1e-9));
    double cells = 0;
    for (const FaceId f : mesh.faces()) {
      for (const HalfedgeId h : Mesh::halfedges(f)) {
        const double at = sizes[mesh.from(h).index()];
        CHECK(std::abs(at - sizes[mesh.to(h).index()]) <= options.gradation * mesh.length(h) / spacing + 1e-9);
        cells += mesh.area(f) / (3 * at * at) / compute_area(mesh);
      }
    }
    CHECK(cells == Approx(1).epsilon(0.05));
  }
  // Sizes that may hardly grow are all equal.
  for (const double size : sizes_at_vertices(test::make_bumpy_sphere(2, 3), 40, {1e-9, 4, {}})) {
    CHECK(size == Approx(1).epsilon(1e-6));
  }
}

TEST_CASE("curvature density: noise that is small against the cells hardly changes it") {
  const Mesh smooth = flattened_sphere();
  constexpr int kCount = 100;
  const double noise = 0.02 * even_spacing(compute_area(smooth), kCount);
  const std::vector<double> without = sizes_at_vertices(smooth, kCount);
  const auto [least, most] = std::minmax_element(without.begin(), without.end());
  CHECK(*most / *least > 1.5);  // so that there is something to change
  for (const unsigned seed : {1U, 2U, 3U}) {
    test::Random random(seed);
    const Mesh noisy = moved(smooth, [&](const Vec3& p) {
      const double x = random.real(-1, 1), y = random.real(-1, 1), z = random.real(-1, 1);
      return Vec3(p + noise * Vec3(x, y, z));
    });
    CHECK(largest_ratio(without, sizes_at_vertices(noisy, kCount)) < 1.1);
  }
}

TEST_CASE("curvature density: neither units nor a finer mesh of the same surface changes it") {
  const Mesh mesh = flattened_sphere();
  const std::vector<double> here = sizes_at_vertices(mesh, 100);
  for (const double unit : {1e-30, 1000.0, 1e30}) {
    const Mesh scaled = moved(mesh, [&](const Vec3& p) { return Vec3(unit * p); });
    CHECK(largest_ratio(here, sizes_at_vertices(scaled, 100)) < 1 + 1e-6);
  }
  const Mesh finer = moved(test::make_sphere(5), [](const Vec3& p) { return Vec3(p.x(), p.y(), p.z() / 4); });
  std::vector<double> there = sizes_at_vertices(finer, 100);
  there.resize(here.size());  // the vertices of the coarser sphere come first
  CHECK(largest_ratio(here, there) < 1.1);
}

TEST_CASE("curvature density: bad options are refused, and a surface without area is uniform") {
  const Mesh mesh = test::make_sphere(1);
  CHECK_THROWS_AS(make_curvature_density(mesh, 10, {0, 4, {}}), Error);
  CHECK_THROWS_AS(make_curvature_density(mesh, 10, {1, 0.5, {}}), Error);
  CHECK_THROWS_AS(make_curvature_density(mesh, 0), Error);
  const Mesh line({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{VertexId(0), VertexId(1), VertexId(2)}});
  CHECK(make_curvature_density(line, 10).is_uniform());
  test::require_cancelled_everywhere([&](const Progress& progress) {
    make_curvature_density(mesh, 10, {0.3, 5, progress});
  });
}

}  // namespace gvd::test_curvature_density
