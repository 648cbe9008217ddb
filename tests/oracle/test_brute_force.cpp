#include <cmath>
#include <limits>

#include "support/brute_force.hpp"
#include "support/catch.hpp"
#include "support/exact_fields.hpp"
#include "support/meshes.hpp"
#include "support/models.hpp"

namespace gvd::test_brute_force {

TEST_CASE("the nearest wins, the least id among equals, and nothing where nothing reaches") {
  const double inf = std::numeric_limits<double>::infinity();
  const test::DistanceFields fields{{0, 2, 1, inf}, {3, 1, 1, inf}};
  const test::Nearest nearest = test::compute_nearest(fields);
  CHECK(nearest.label.raw() == std::vector<GeneratorId>{GeneratorId(0), GeneratorId(1), GeneratorId(0), GeneratorId()});
  CHECK(nearest.distance.raw() == std::vector<double>{0, 1, 1, inf});
  CHECK(test::find_wrong_labels(fields, nearest.label).empty());
}

TEST_CASE("a label is right within the tolerance and wrong beyond it") {
  const test::DistanceFields fields{{1, 1}, {1 + 1e-10, 1 + 1e-8}};
  CHECK(test::is_right_label(fields, VertexId(0), GeneratorId(1)));
  CHECK_FALSE(test::is_right_label(fields, VertexId(1), GeneratorId(1)));
  CHECK_FALSE(test::is_right_label(fields, VertexId(0), GeneratorId()));
  CHECK_FALSE(test::is_right_label(fields, VertexId(0), GeneratorId(2)));
}

TEST_CASE("brute force by the exact solver and by the reference give the same labels") {
  const auto found = test::find_reference("eight.m10");
  if (!found) return;
  const test::Reference& eight = *found;
  std::vector<SurfacePoint> generators;
  for (const VertexId v : eight.generators) generators.push_back(vertex_point(eight.mesh, v));
  const test::Nearest nearest = test::compute_nearest(test::exact_vertex_fields(eight.mesh, generators));
  CHECK(test::find_wrong_labels(eight.distances, nearest.label).empty());
}

TEST_CASE("a component without a generator has no label") {
  const Mesh mesh = test::make_two_components();
  const auto nearest = test::compute_nearest(test::exact_vertex_fields(mesh, {vertex_point(mesh, VertexId(0))}));
  CHECK(nearest.label[VertexId(0)] == GeneratorId(0));
  CHECK_FALSE(nearest.label[VertexId(mesh.vertex_count() - 1)].valid());
}

}  // namespace gvd::test_brute_force
