// Exact diagrams against the reference distances, and against CGAL's exact shortest paths.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "gvd/diagram.hpp"
#include "gvd/exact_field.hpp"
#include "gvd/verify.hpp"
#include "oracle/equidistance.hpp"
#include "support/brute_force.hpp"
#include "support/catch.hpp"
#include "support/exact_fields.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/models.hpp"

namespace gvd::test_exact_diagram {

constexpr double kRelative = 1e-12;

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

TEST_CASE("an exact field of one generator has the reference's distances at every vertex") {
  for (const std::string& name : test::list_references()) {
    const test::Reference reference = test::read_reference(name);
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
  for (const std::string& name : test::list_references()) {
    INFO(name);
    const test::Reference reference = test::read_reference(name);
    const Diagram diagram = test::compute_sound_exact(reference.mesh, reference.generator_points());
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
  for (const std::string& name : test::list_references()) {
    INFO(name);
    const test::Reference reference = test::read_reference(name);
    const Diagram diagram = test::compute_sound_exact(reference.mesh, reference.generator_points());
    CHECK(verify_diagram(reference.mesh, diagram).error_mean < 1e-5 * mean(nearest_distances(reference)));
  }
}

TEST_CASE("crossings and branch points are equally far by CGAL's shortest paths") {
  for (const auto& [name, mesh] : test::small_family()) {
    for (const int count : {2, 8, 25}) {
      for (const unsigned seed : {31U, 32U}) {
        INFO(name << ", " << count << " generators, seed " << seed);
        test::require_equidistant(mesh, test::compute_sound_exact(mesh, test::random_generators(mesh, count, seed)));
      }
    }
  }
}

TEST_CASE("labels and distances at vertices are those of CGAL's shortest paths from each generator alone") {
  for (const auto& [name, mesh] : test::small_family()) {
    for (const int count : {3, 20}) {
      INFO(name << ", " << count << " generators");
      const Diagram diagram = test::compute_sound_exact(mesh, test::random_generators(mesh, count, 41));
      const auto fields = test::exact_vertex_fields(mesh, diagram.generators);
      CHECK(test::find_wrong_labels(fields, diagram.vertex_label).empty());
      const auto nearest = test::compute_nearest(fields).distance.raw();
      CHECK(worst_of(diagram.vertex_distance.raw(), nearest) <= kRelative);
    }
  }
}

TEST_CASE("E of exact diagrams falls with the chord tolerance") {
  const Mesh mesh = test::make_bumpy_sphere(2, 7);
  const auto generators = test::random_generators(mesh, 6, 5);
  double before = std::numeric_limits<double>::infinity();
  for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
    INFO(tolerance);
    const double error = verify_diagram(mesh, test::compute_sound_exact(mesh, generators, tolerance)).error_mean;
    CHECK(error <= tolerance * mesh.mean_edge_length());
    CHECK(error < 0.3 * before);
    before = error;
  }
}

}  // namespace gvd::test_exact_diagram
