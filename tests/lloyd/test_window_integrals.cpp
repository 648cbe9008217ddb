#include <cmath>

#include "base/plane.hpp"
#include "diagram/diagram_windows.hpp"
#include "gvd/geodesic_tracing.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/many_threads.hpp"
#include "support/meshes.hpp"
#include "support/same_diagram.hpp"
#include "support/tiny_meshes.hpp"
#include "window_integrals.hpp"

namespace gvd::test_window_integrals {

using Moments = IdVector<GeneratorId, CellMoments>;

Moments integrate(const Mesh& mesh, const std::vector<SurfacePoint>& generators, int divisions = 1, int threads = 1,
                  Diagram* out = nullptr, const Density& density = {}) {
  const Progress silent;
  DiagramOptions options;
  options.threads = threads;
  Moments moments;
  Diagram traced = compute_diagram_and_read(
      mesh, generators, options, KeepWindows::all, [&](const auto& working, const auto& field, const auto& diagram) {
        moments =
            integrate_over_windows(working, field, diagram, {density, {}}, ParallelChunks(threads, silent), divisions)
                .moments;
      });
  if (out) *out = std::move(traced);
  return moments;
}

double energy(const Moments& moments) {
  double sum = 0;
  for (const CellMoments& cell : moments) sum += cell.energy;
  return sum;
}

/// Generators of which the first one lies in a face or on an edge, and a direction in which it can move.
struct Movable {
  std::vector<SurfacePoint> generators;
  Vec2 way;
};

Movable make_movable(const Mesh& mesh, unsigned seed) {
  Movable movable{test::random_generators(mesh, 6, seed), unit_vector(1 + seed)};
  std::swap(movable.generators[0], movable.generators[seed % 2 == 0 ? 1 : 2]);
  return movable;
}

TEST_CASE("window integrals: exact on a flat rectangle, wherever the generator lies") {
  const Mesh grid = test::make_grid(5, 3);
  for (const SurfacePoint& generator : test::random_generators(grid, 12, 2)) {
    const Vec3 at = position(grid, generator);
    const CellMoments cell = integrate(grid, {generator})[GeneratorId(0)];
    const double x = at.x() - 2.5, y = at.y() - 1.5;
    CHECK(cell.area == Approx(15).epsilon(1e-12));
    CHECK(cell.energy == Approx(15 * (x * x + y * y + 25.0 / 12 + 9.0 / 12)).epsilon(1e-12));
    CHECK(cell.centroid.norm() == Approx(std::hypot(x, y)).epsilon(1e-7));
    const Vec3 centroid = position(grid, trace_geodesic(grid, generator, cell.centroid).points.back());
    CHECK((centroid - Vec3(2.5, 1.5, 0)).norm() < 1e-7);
  }
}

TEST_CASE("window integrals: straight cells of a flat rectangle, exact up to the chord tolerance") {
  const Mesh grid = test::make_grid(8, 8);
  const auto at = [&](int x, int y) {  // the centre of a quarter
    for (std::int32_t v = 0; v < grid.vertex_count(); ++v) {
      if ((grid.position(VertexId(v)) - Vec3(x, y, 0)).norm() < 1e-9) return vertex_point(grid, VertexId(v));
    }
    return SurfacePoint();
  };
  for (const CellMoments& cell : integrate(grid, {at(2, 2), at(6, 2), at(2, 6), at(6, 6)})) {
    CHECK(cell.area == Approx(16));
    CHECK(cell.energy == Approx(16 * 2 * 16 / 12.0));
    CHECK(cell.centroid.norm() < 1e-9);
  }
}

TEST_CASE("window integrals: more divisions converge, and areas are those of the cells") {
  for (const auto& [name, mesh] : test::small_family()) {
    CAPTURE(name);
    const auto generators = test::random_generators(mesh, 7, 4);
    Diagram diagram;
    const Moments rough = integrate(mesh, generators, 1), fine = integrate(mesh, generators, 4),
                  finest = integrate(mesh, generators, 16, 1, &diagram);
    for (const Cell& cell : diagram.cells) {
      CHECK(finest[cell.generator].area == Approx(cell.area).epsilon(1e-9));
    }
    CHECK(energy(rough) == Approx(energy(finest)).epsilon(2e-3));
    CHECK(energy(fine) == Approx(energy(finest)).epsilon(2e-4));
    CHECK(std::abs(energy(fine) - energy(finest)) <= std::abs(energy(rough) - energy(finest)) + 1e-9 * energy(fine));
  }
}

TEST_CASE("window integrals: the centroids are the gradient of the energy") {
  for (const test::NamedMesh& named : test::small_family()) {
    CAPTURE(named.name);
    const Mesh& mesh = named.mesh;
    for (unsigned seed = 0; seed < 4; ++seed) {
      CAPTURE(seed);
      const Movable movable = make_movable(mesh, seed);
      const std::vector<SurfacePoint>& generators = movable.generators;
      const Vec2& way = movable.way;
      const double step = 1e-3 * mesh.mean_edge_length();
      const auto moved = [&](double length) {
        auto to = generators;
        const GeodesicTrace trace = trace_geodesic(mesh, generators[0], length * way);
        to[0] = trace.points.back();
        return trace.complete ? energy(integrate(mesh, to, 8)) : std::nan("");
      };
      const double ahead = moved(step), behind = moved(-step);
      if (std::isnan(ahead) || std::isnan(behind)) continue;  // over the boundary
      const CellMoments cell = integrate(mesh, generators, 8)[GeneratorId(0)];
      const double slope = -2 * cell.area * cell.centroid.dot(way);
      const double scale = 2 * cell.area * std::sqrt(cell.area);
      CHECK((ahead - behind) / (2 * step) == Approx(slope).margin(1e-4 * scale));
    }
  }
}

TEST_CASE("window integrals: the same to the last bit on any number of threads") {
  for (const test::NamedMesh& named : test::small_family()) {
    CAPTURE(named.name);
    const Mesh& mesh = named.mesh;
    const auto generators = test::random_generators(mesh, 5, 1);
    const Moments one = integrate(mesh, generators);
    test::with_many_threads([&] {
      for (const int threads : test::kThreads) {
        const Moments several = integrate(mesh, generators, 1, threads);
        for (std::size_t i = 0; i < one.size(); ++i) {
          const GeneratorId g(i);
          CHECK(several[g].area == one[g].area);
          CHECK(several[g].energy == one[g].energy);
          CHECK(several[g].centroid == one[g].centroid);
        }
      }
    });
  }
}

TEST_CASE("window integrals: reading the windows changes a diagram within the chord tolerance at most") {
  for (const auto& [name, mesh] : test::small_family()) {
    CAPTURE(name);
    const auto generators = test::random_generators(mesh, 8, 3);
    int reads = 0;
    const auto count = [&](const auto&, const auto&, const auto&) { ++reads; };
    const Diagram read = compute_diagram_and_read(mesh, generators, {}, KeepWindows::all, count),
                  plain = compute_diagram(mesh, generators);
    CHECK(reads == 1);
    // Windows come in another order, which decides ties of sources where arcs are split.
    CHECK(test::same_topology(read, plain, test::PointCounts::any));
    CHECK(read.length == Approx(plain.length).epsilon(1e-5));
  }
}

TEST_CASE("window integrals: a density weighs mass, energy and centroid") {
  const Mesh grid = test::make_grid(6, 2);
  std::vector<double> heavy;  // 1 on the left half, 3 on the right one
  for (std::int32_t f = 0; f < grid.face_count(); ++f) {
    double x = 0;
    for (const VertexId v : grid.vertices(FaceId(f))) x += grid.position(v).x() / 3;
    heavy.push_back(x < 3 ? 1 : 3);
  }
  const auto generators = std::vector{vertex_point(grid, VertexId(0))};
  const CellMoments cell = integrate(grid, generators, 1, 1, nullptr, make_face_density(grid, heavy))[GeneratorId(0)];
  CHECK(cell.area == Approx(12));
  CHECK(cell.mass == Approx(6 + 18));
  const Vec3 from = position(grid, generators[0]);
  const Vec3 mean = (6 * Vec3(1.5, 1, 0) + 18 * Vec3(4.5, 1, 0)) / 24;
  CHECK(cell.centroid.norm() == Approx((mean - from).norm()).epsilon(1e-7));
  const Moments doubled = integrate(grid, generators, 1, 1, nullptr,
                                    make_vertex_density(grid, std::vector<double>(grid.positions().size(), 2)));
  const Moments plain = integrate(grid, generators);
  CHECK(doubled[GeneratorId(0)].energy == Approx(2 * plain[GeneratorId(0)].energy));
  CHECK((doubled[GeneratorId(0)].centroid - plain[GeneratorId(0)].centroid).norm() < 1e-12);
}

}  // namespace gvd::test_window_integrals
