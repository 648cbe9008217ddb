// The lower envelope of linear functions over a triangle, beside their minimum at points.
// Cells that are measured face by face, beside those of diagrams.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "gvd/geodesic_tracing.hpp"
#include "gvd/lloyd.hpp"
#include "gvd/mesh.hpp"
#include "lower_envelope.hpp"
#include "measured_cells.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/many_threads.hpp"
#include "support/meshes.hpp"
#include "support/random.hpp"

namespace gvd::test_measured_cells {

using Function = std::array<double, 3>;

double area(const EnvelopePart& part) {  // of the whole triangle: 1
  double sum = 0;
  for (std::size_t i = 0; i < part.corners.size(); ++i) {
    const Bary &a = part.corners[i], &b = part.corners[(i + 1) % part.corners.size()];
    sum += a[1] * b[2] - b[1] * a[2];
  }
  return sum;
}

double total_area(const std::vector<EnvelopePart>& parts) {
  double sum = 0;
  for (const EnvelopePart& part : parts) sum += area(part);
  return sum;
}

std::vector<EnvelopePart> lower_envelope(const std::vector<Function>& values) {
  LowerEnvelope envelope;
  const auto parts = envelope.compute(values);
  return {parts.begin(), parts.end()};
}

double value(const Function& f, const Bary& at) { return f[0] * at[0] + f[1] * at[1] + f[2] * at[2]; }

TEST_CASE("lower envelope: one function has the whole triangle, and of equal ones the first") {
  for (const std::size_t count : {1, 2, 3}) {
    const auto parts = lower_envelope(std::vector<Function>(count, {1, 2, 3}));
    REQUIRE(parts.size() == 1);
    CHECK(parts[0].function == 0);
    CHECK(parts[0].corners.size() == 3);
    CHECK(std::count(parts[0].across.begin(), parts[0].across.end(), kTriangleSide) == 3);
  }
  CHECK(lower_envelope({}).empty());
}

TEST_CASE("lower envelope: nothing is left of the one before") {
  LowerEnvelope envelope;
  CHECK(envelope.compute({{0, 1, 1}, {1, 0, 0}, {1, 1, 0}}).size() > 1);
  const auto parts = envelope.compute({{1, 2, 3}});
  REQUIRE(parts.size() == 1);
  CHECK(parts[0].corners.size() == 3);
  CHECK(envelope.compute({}).empty());
}

TEST_CASE("lower envelope: two functions cut the triangle along a line, and each knows the other") {
  const auto parts = lower_envelope({{0, 1, 1}, {1, 0, 0}});
  REQUIRE(parts.size() == 2);
  CHECK(area(parts[0]) == Approx(0.25));
  CHECK(area(parts[1]) == Approx(0.75));
  CHECK(std::count(parts[0].across.begin(), parts[0].across.end(), 1) == 1);
  CHECK(std::count(parts[1].across.begin(), parts[1].across.end(), 0) == 1);
}

TEST_CASE("lower envelope: parts are where their function is least, and cover the triangle") {
  test::Random random(1);
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<Function> values(static_cast<std::size_t>(1 + trial % 9));
    for (Function& f : values) f = {random.real(0, 1), random.real(0, 1), random.real(0, 1)};
    if (trial % 4 == 0) values.push_back(values[0]);
    if (trial % 5 == 0) values.push_back({values[0][0], random.real(0, 1), random.real(0, 1)});
    const auto parts = lower_envelope(values);
    CHECK(total_area(parts) == Approx(1).epsilon(1e-12));
    for (const EnvelopePart& part : parts) {
      for (std::size_t i = 0; i < part.corners.size(); ++i) {
        const Bary& at = part.corners[i];
        for (const Function& f : values) CHECK(value(values[part.function], at) <= value(f, at) + 1e-12);
        if (part.across[i] == kTriangleSide) continue;
        CHECK(std::abs(value(values[part.function], at) - value(values[part.across[i]], at)) < 1e-12);
      }
    }
  }
}

MeasuredCells measure(const Mesh& mesh, const std::vector<SurfacePoint>& generators, int threads = 1) {
  return measure_cells(mesh, generators, {Density(), {}}, threads, {});
}

double energy(const MeasuredCells& cells) {
  double sum = 0;
  for (const CellMoments& cell : cells.integrals.moments) sum += cell.energy;
  return sum;
}

std::vector<std::pair<std::string, Mesh>> fine_meshes() {
  return {{"sphere", test::make_sphere(4)}, {"bumpy sphere", test::make_bumpy_sphere(4, 5)}};
}

TEST_CASE("measured cells: areas, energies and centroids are near those of the diagram") {
  for (const auto& [name, mesh] : fine_meshes()) {
    for (unsigned seed = 0; seed < 3; ++seed) {
      CAPTURE(name, seed);
      const auto generators = test::random_generators(mesh, 12, seed);
      const MeasuredCells cells = measure(mesh, generators);
      const Diagram diagram = compute_diagram(mesh, generators);
      const auto exact = compute_cell_moments(mesh, diagram);
      double whole = 0, area = 0;
      for (const CellMoments& cell : exact) {
        whole += cell.energy;
        area += cell.area;
      }
      CHECK(energy(cells) == Approx(whole).epsilon(2e-4));
      const double radius = std::sqrt(area / 12 / 3.14159);
      for (std::size_t i = 0; i < 12; ++i) {
        const GeneratorId g(i);
        CHECK(cells.integrals.moments[g].area == Approx(exact[g].area).margin(0.001 * area / 12));
        CHECK((cells.integrals.moments[g].centroid - exact[g].centroid).norm() < 0.005 * radius);
      }
      for (std::int32_t v = 0; v < mesh.vertex_count(); ++v)
        CHECK(cells.geometry.vertex_distance[VertexId(v)] ==
              Approx(diagram.vertex_distance[VertexId(v)]).margin(1e-12));
    }
  }
}

TEST_CASE("measured cells: few faces for each generator are enough") {
  for (const auto& [name, mesh] : test::small_family()) {
    CAPTURE(name);
    const int count = mesh.face_count() / 3;
    const auto generators = test::random_generators(mesh, count, 1);
    const MeasuredCells cells = measure(mesh, generators);
    double whole = 0, area = 0;
    for (const CellMoments& cell : compute_cell_moments(mesh, compute_diagram(mesh, generators))) whole += cell.energy;
    for (const CellMoments& cell : cells.integrals.moments) area += cell.area;
    CHECK(energy(cells) == Approx(whole).epsilon(2e-3));
    CHECK(area == Approx(compute_area(mesh)).epsilon(1e-9));
  }
}

TEST_CASE("measured cells: a component without a generator has no cell") {
  const Mesh mesh = test::make_two_components();
  const MeasuredCells cells = measure(mesh, test::random_generators(mesh, 1, 0));
  REQUIRE(cells.integrals.moments.size() == 1);
  const double area = cells.integrals.moments[GeneratorId(0)].area;
  CHECK(area > 0);
  CHECK(area < 0.9 * compute_area(mesh));
  CHECK(cells.geometry.segments.empty());
}

TEST_CASE("measured cells: the mean log maps are nearly the gradient of the energy") {
  for (const auto& named : fine_meshes()) {
    const Mesh& mesh = named.second;
    for (unsigned seed = 0; seed < 5; ++seed) {
      CAPTURE(named.first, seed);
      const auto generators = test::random_generators(mesh, 12, seed);
      const std::size_t i = generators[0].kind() == SurfacePoint::Kind::vertex ? 1 : 0;
      const CellMoments cell = measure(mesh, generators).integrals.moments[GeneratorId(i)];
      const Vec2 way(0.6, 0.8);
      const double h = 0.003 * std::sqrt(cell.area);
      const auto at = [&](double step) {
        auto moved = generators;
        moved[i] = trace_geodesic(mesh, generators[i], step * way).points.back();
        return energy(measure(mesh, moved));
      };
      // The generator splits its face, whose points move with it. That is the difference.
      const double slope = (at(h) - at(-h)) / (2 * h);
      CHECK(slope == Approx(-2 * cell.mass * cell.centroid.dot(way)).margin(0.02 * cell.mass * std::sqrt(cell.area)));
    }
  }
}

TEST_CASE("measured cells: segments lie between neighbouring cells, and have the length of the bisectors") {
  const Mesh mesh = test::make_sphere(4);
  const auto generators = test::random_generators(mesh, 12, 2);
  const MeasuredCells cells = measure(mesh, generators);
  const Diagram diagram = compute_diagram(mesh, generators);
  double exact = 0;
  for (const Bisector& bisector : diagram.bisectors) {
    for (std::size_t k = 0; k + 1 < bisector.points.size() && bisector.left != bisector.right; ++k) {
      exact += (position(mesh, bisector.points[k + 1]) - position(mesh, bisector.points[k])).norm();
    }
  }
  std::ptrdiff_t expected = 0;
  for (const Cell& cell : diagram.cells) expected += std::ssize(cell.neighbours);
  const auto length = [](const std::vector<BisectorSegment>& segments) {
    double sum = 0;
    for (const BisectorSegment& s : segments) sum += s.length;
    return sum;
  };
  CHECK(length(cells.geometry.segments) == Approx(exact).epsilon(0.01));
  const auto pairs = neighbouring_cells(cells.geometry.segments);
  CHECK(std::abs(std::ssize(pairs) - expected / 2) <= 2);
  for (const auto& [left, right] : pairs) CHECK(left < right);
}

TEST_CASE("measured cells: the same on any number of threads, to the last bit") {
  const Mesh mesh = test::make_bumpy_sphere(5, 3);
  const auto generators = test::random_generators(mesh, 40, 3);
  const MeasuredCells one = measure(mesh, generators);
  test::with_many_threads([&] {
    for (const int threads : {2, 5}) {
      const MeasuredCells many = measure(mesh, generators, threads);
      CHECK(energy(many) == energy(one));
      for (std::size_t i = 0; i < generators.size(); ++i) {
        const GeneratorId g(i);
        CHECK(many.integrals.moments[g].centroid == one.integrals.moments[g].centroid);
      }
      CHECK(many.geometry.segments.size() == one.geometry.segments.size());
    }
  });
}

}  // namespace gvd::test_measured_cells
