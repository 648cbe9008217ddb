// Diagrams from the caller's distances: good ones, bad ones, and none.
#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include "gvd/check.hpp"
#include "gvd/error.hpp"
#include "gvd/trace_diagram.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/refusal.hpp"
#include "support/same_diagram.hpp"

namespace gvd::test_trace_diagram {

using test::random_generators;
using test::small_family;

constexpr std::array<Tracer, 3> kTracers{Tracer::growth, Tracer::paper, Tracer::envelope};

// Distances of all generators: "along straight lines" in space, which any noise may change.
template <class Change>
std::vector<double> straight_distances(const Mesh& mesh, const std::vector<SurfacePoint>& generators, Change change) {
  std::vector<double> distances;
  for (const SurfacePoint& generator : generators) {
    const Vec3 from = position(mesh, generator);
    for (const Vec3& p : mesh.positions()) distances.push_back(change((p - from).norm()));
  }
  return distances;
}

Diagram require_sound(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                      const std::vector<double>& distances, Tracer tracer = Tracer::growth) {
  DiagramOptions options = growth_options();
  options.method.tracer = tracer;
  Diagram diagram = trace_diagram(mesh, generators, distances, options);
  const DiagramCheck check = check_diagram(mesh, diagram);
  CAPTURE(check.violations);
  REQUIRE(check.ok());
  REQUIRE(diagram.report.unresolved_ends == 0);
  for (const Cell& cell : diagram.cells) REQUIRE(cell.components == 1);
  return diagram;
}

TEST_CASE("trace_diagram: a complete connected diagram from distances through space, with any tracer") {
  for (const auto& [name, mesh] : small_family()) {
    for (const int m : {1, 2, 7, 40}) {
      for (const unsigned seed : {3U, 4U}) {
        const auto generators = random_generators(mesh, m, seed);
        const auto distances = straight_distances(mesh, generators, [](double d) { return d; });
        for (const Tracer tracer : kTracers) {
          INFO(name << ", " << m << " generators, seed " << seed << ", tracer " << static_cast<int>(tracer));
          require_sound(mesh, generators, distances, tracer);
        }
      }
    }
  }
}

TEST_CASE("trace_diagram: whatever the numbers are, cells are connected and the diagram is complete") {
  constexpr double kUnknown = std::numeric_limits<double>::infinity();
  for (const auto& [name, mesh] : small_family()) {
    const double edge = mesh.mean_edge_length();
    for (const int m : {3, 20}) {
      for (const unsigned seed : {5U}) {
        const auto generators = random_generators(mesh, m, seed);
        std::mt19937 random(seed);
        const auto real = [&] { return double(random()) / double(std::mt19937::max()); };
        const std::vector<std::pair<const char*, std::function<double(double)>>> changes{
            {"noise of half an edge", [&](double d) { return d + 0.5 * edge * real(); }},
            {"noise only", [&](double) { return real(); }},
            {"rounded to edges", [&](double d) { return edge * std::round(d / edge); }},
            {"all zero", [](double) { return 0.0; }},
            {"all one", [](double) { return 1.0; }},
            {"none is known", [](double) { return kUnknown; }},
            {"half are unknown", [&](double d) { return random() % 2 == 0 ? d : kUnknown; }},
            {"of all sizes", [&](double) { return std::pow(10.0, 200 * real() - 100); }},
            {"backwards", [&](double d) { return std::max(0.0, 10 - d); }}};
        for (const auto& [what, change] : changes) {
          const auto distances = straight_distances(mesh, generators, change);
          for (const Tracer tracer : kTracers) {
            INFO(name << ", " << m << " generators, seed " << seed << ", " << what << ", tracer "
                      << static_cast<int>(tracer));
            require_sound(mesh, generators, distances, tracer);
          }
        }
      }
    }
  }
}

TEST_CASE("trace_diagram: labels and distances are those of the rows, and on a flat mesh the bisector is straight") {
  const Mesh mesh = test::make_grid(12, 8);
  const std::vector<SurfacePoint> generators{vertex_point(mesh, VertexId(0)),
                                             vertex_point(mesh, VertexId(mesh.vertex_count() - 1))};
  const Vec3 a = position(mesh, generators[0]), b = position(mesh, generators[1]);
  const Diagram diagram =
      require_sound(mesh, generators, straight_distances(mesh, generators, [](double d) { return d; }));
  REQUIRE(diagram.bisectors.size() == 1);
  for (const SurfacePoint& point : diagram.bisectors[BisectorId(0)].points) {
    const Vec3 p = position(mesh, point);
    CHECK(std::abs((p - a).norm() - (p - b).norm()) < 1e-6);
  }
  for (const VertexId v : mesh.vertices()) {
    const double da = (mesh.position(v) - a).norm(), db = (mesh.position(v) - b).norm();
    CHECK(std::abs(diagram.vertex_distance[v] - std::min(da, db)) < 1e-9);
    CHECK(diagram.vertex_label[v] == GeneratorId(da <= db ? 0 : 1));
  }
}

TEST_CASE("trace_diagram: an array and a callback give the same diagram, which asks once for each row in order") {
  const Mesh mesh = test::make_bumpy_sphere(2, 1);
  const auto generators = random_generators(mesh, 9, 2);
  const auto distances = straight_distances(mesh, generators, [](double d) { return d; });
  const std::size_t n = std::size_t(mesh.vertex_count());
  int asked = 0;
  const Diagram by_rows = trace_diagram(mesh, generators, [&](GeneratorId g, std::span<double> row) {
    REQUIRE(g.value() == asked++);
    REQUIRE(row.size() == n);
    for (std::size_t v = 0; v < n; ++v) {
      REQUIRE(row[v] == std::numeric_limits<double>::infinity());
      row[v] = distances[g.index() * n + v];
    }
  });
  CHECK(asked == 9);
  CHECK(test::same_diagram(trace_diagram(mesh, generators, distances), by_rows));
}

TEST_CASE("trace_diagram: what a row says of other components is ignored, and components without generators stay out") {
  const Mesh mesh = test::make_two_components();
  const std::vector<SurfacePoint> one{vertex_point(mesh, VertexId(0))};
  std::vector<double> distances = straight_distances(mesh, one, [](double) { return 0.0; });
  const Diagram diagram = require_sound(mesh, one, distances);
  int unreached = 0;
  for (const VertexId v : mesh.vertices()) {
    if (diagram.vertex_label[v].valid()) continue;
    ++unreached;
    distances[v.index()] = std::numeric_limits<double>::quiet_NaN();  // as solvers of heat flow leave it there
  }
  CHECK(test::same_diagram(diagram, trace_diagram(mesh, one, distances)));
  CHECK(unreached > 0);
  CHECK(unreached < mesh.vertex_count());
}

TEST_CASE("trace_diagram: a generator that is the nearest nowhere keeps a cell around its vertex") {
  const Mesh mesh = test::make_sphere(3);
  const std::vector<SurfacePoint> generators{vertex_point(mesh, VertexId(0)), vertex_point(mesh, VertexId(100))};
  std::vector<double> distances(2 * std::size_t(mesh.vertex_count()), 0.25);
  std::fill(distances.begin() + mesh.vertex_count(), distances.end(), 1e6);
  const Diagram diagram = require_sound(mesh, generators, distances);
  CHECK(diagram.vertex_label[VertexId(100)] == GeneratorId(1));
  CHECK(diagram.cells[GeneratorId(1)].area > 0);
  CHECK(diagram.cells[GeneratorId(1)].area < 0.05 * diagram.cells[GeneratorId(0)].area);
}

TEST_CASE("trace_diagram: bad numbers and sizes are refused in one line") {
  const Mesh mesh = test::make_grid(3, 3);
  const std::vector<SurfacePoint> generators{vertex_point(mesh, VertexId(0)), vertex_point(mesh, VertexId(15))};
  const auto distances = straight_distances(mesh, generators, [](double d) { return d; });
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), -1e-9, -std::numeric_limits<double>::infinity(),
                           2 * kLongestDistance}) {
    std::vector<double> wrong = distances;
    wrong[16 + 7] = bad;
    CHECK_THAT(test::refusal([&] { trace_diagram(mesh, generators, wrong); }, ErrorCode::precondition),
               Catch::Matchers::StartsWith("the distance of generator 1 at vertex 7 is "));
  }
  std::vector<double> shorter(distances.begin(), distances.end() - 1);
  CHECK(test::refusal([&] { trace_diagram(mesh, generators, shorter); }, ErrorCode::invalid_option) ==
        "there are 31 distances; 2 generators and 16 vertices need 32");
  CHECK_THROWS_AS(trace_diagram(mesh, {}, std::vector<double>()), Error);
  const std::vector<SurfacePoint> twice{generators[0], generators[0]};
  CHECK_THROWS_AS(trace_diagram(mesh, twice, distances), Error);
  struct Stop {};
  CHECK_THROWS_AS(trace_diagram(mesh, generators, [](GeneratorId, std::span<double>) { throw Stop(); }), Stop);
}

}  // namespace gvd::test_trace_diagram
