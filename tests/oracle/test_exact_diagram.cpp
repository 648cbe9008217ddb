// Exact diagrams against the reference distances, and against CGAL's exact shortest paths.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "gvd/check.hpp"
#include "gvd/diagram.hpp"
#include "gvd/exact_field.hpp"
#include "gvd/verify.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/reference.hpp"
#include "support/shared_data.hpp"

using namespace gvd;

namespace {

constexpr double kRelative = 1e-12;

Diagram compute_exact(const Mesh& mesh, const std::vector<SurfacePoint>& generators, double chord_tolerance = 1e-4) {
  DiagramOptions options;
  options.method = Method::exact;
  options.chord_tolerance = chord_tolerance;
  Diagram diagram = compute_diagram(mesh, generators, options);
  const DiagramCheck check = check_diagram(mesh, diagram);
  for (const std::string& violation : check.violations) UNSCOPED_INFO(violation);
  REQUIRE(check.ok());
  return diagram;
}

std::vector<SurfacePoint> vertex_points(const test::Reference& reference) {
  std::vector<SurfacePoint> points;
  for (const VertexId v : reference.generators) points.push_back(vertex_point(reference.mesh, v));
  return points;
}

std::vector<double> nearest_distances(const test::Reference& reference) {
  std::vector<double> nearest = reference.distances.front();
  for (const auto& row : reference.distances) {
    for (std::size_t v = 0; v < row.size(); ++v) nearest[v] = std::min(nearest[v], row[v]);
  }
  return nearest;
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

/// The largest difference, relative to the expected value.
double worst_of(const std::vector<double>& actual, const std::vector<double>& expected) {
  double worst = 0;
  for (std::size_t i = 0; i < actual.size(); ++i) {
    if (actual[i] != expected[i]) worst = std::max(worst, std::abs(actual[i] - expected[i]) / expected[i]);
  }
  return worst;
}

}  // namespace

TEST_CASE("an exact field of one generator has the reference's distances at every vertex") {
  const auto shared = test::shared_folder();
  if (!shared) return;
  for (const std::string& name : test::list_references(*shared / "reference")) {
    const test::Reference reference = test::read_reference(*shared / "reference", name);
    for (std::size_t g = 0; g < reference.generators.size(); g += 4) {
      INFO(name << ", generator " << g);
      const ExactField field(reference.mesh, {vertex_point(reference.mesh, reference.generators[g])});
      std::vector<double> distances;
      for (int v = 0; v < reference.mesh.vertex_count(); ++v) distances.push_back(field.distance(VertexId(v)));
      CHECK(worst_of(distances, reference.distances[g]) <= kRelative);
    }
  }
}

TEST_CASE("an exact diagram has the reference's nearest distance at every vertex, and a label that has it") {
  const auto shared = test::shared_folder();
  if (!shared) return;
  for (const std::string& name : test::list_references(*shared / "reference")) {
    INFO(name);
    const test::Reference reference = test::read_reference(*shared / "reference", name);
    const Diagram diagram = compute_exact(reference.mesh, vertex_points(reference));
    const auto nearest = nearest_distances(reference);
    CHECK(worst_of(diagram.vertex_distance.raw(), nearest) <= kRelative);
    std::vector<double> of_label;
    for (int v = 0; v < reference.mesh.vertex_count(); ++v) {
      REQUIRE(diagram.vertex_label[VertexId(v)].valid());
      of_label.push_back(reference.distances[diagram.vertex_label[VertexId(v)].index()][std::size_t(v)]);
    }
    CHECK(worst_of(of_label, nearest) <= 1e-9);
  }
}

TEST_CASE("on the reference meshes the bisectors are off by less than 1e-5 of the mean distance") {
  const auto shared = test::shared_folder();
  if (!shared) return;
  for (const std::string& name : test::list_references(*shared / "reference")) {
    INFO(name);
    const test::Reference reference = test::read_reference(*shared / "reference", name);
    const Diagram diagram = compute_exact(reference.mesh, vertex_points(reference));
    CHECK(verify_diagram(reference.mesh, diagram).error_mean < 1e-5 * mean(nearest_distances(reference)));
  }
}

TEST_CASE("crossings and branch points are equally far by CGAL's shortest paths") {
  // The verifier's own error is 1e-9 of the distance at worst; on these meshes it is much less.
  constexpr double kEquidistant = 1e-12;
  for (const auto& [name, mesh] : test::small_family()) {
    if (mesh.face_count() > 700) continue;
    INFO(name);
    const Diagram diagram = compute_exact(mesh, test::random_generators(mesh, 8, 31));
    std::vector<DistanceQuery> queries;
    for (const SurfacePoint& g : diagram.generators) queries.push_back({g, {}});
    for (const BranchPoint& b : diagram.branch_points) {
      for (DistanceQuery& query : queries) query.points.push_back(b.point);
    }
    std::vector<std::array<GeneratorId, 2>> pairs;
    for (const Bisector& b : diagram.bisectors) {
      for (const SurfacePoint& p : b.points) {
        if (p.kind() == SurfacePoint::Kind::face) continue;
        pairs.push_back({b.left, b.right});
        for (DistanceQuery& query : queries) query.points.push_back(p);
      }
    }
    const auto distances = compute_exact_distances(mesh, queries);
    const double least = kEquidistant * mesh.bbox_diagonal();
    double worst = 0;
    for (std::size_t i = 0; i < diagram.branch_points.size(); ++i) {
      const auto& cells = diagram.branch_points[BranchPointId(std::int64_t(i))].generators;
      for (const GeneratorId g : cells)
        worst = std::max(worst, distances[g.index()][i] - distances[cells[0].index()][i]);
      for (const auto& row : distances) CHECK(row[i] >= distances[cells[0].index()][i] - least);
    }
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const auto& [left, right] = pairs[i];
      const std::size_t at = diagram.branch_points.size() + i;
      worst = std::max(worst, std::abs(distances[left.index()][at] - distances[right.index()][at]));
    }
    CHECK(worst <= least);
  }
}

TEST_CASE("E of exact diagrams falls with the chord tolerance") {
  const Mesh mesh = test::make_bumpy_sphere(2, 7);
  const auto generators = test::random_generators(mesh, 6, 5);
  double before = std::numeric_limits<double>::infinity();
  for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
    INFO(tolerance);
    const double error = verify_diagram(mesh, compute_exact(mesh, generators, tolerance)).error_mean;
    CHECK(error <= tolerance * mesh.mean_edge_length());
    CHECK(error < 0.3 * before);
    before = error;
  }
}
