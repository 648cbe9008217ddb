// The model of the energy: its gradient, its cones against true energies, and its minimum.
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "energy_model.hpp"
#include "generator_moves.hpp"
#include "gvd/lloyd.hpp"
#include "gvd/sampling.hpp"
#include "gvd/surface_point.hpp"
#include "lloyd/states.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

namespace gvd::test_energy_model {

using test::evaluate_state;

const GeneratorConstraints kFree;

/// Generators of a rough sphere, one of which is beside a vertex.
std::vector<SurfacePoint> generators_beside(const Mesh& mesh, VertexId v, double share) {
  SamplingOptions sampling;
  sampling.count = 11;
  sampling.seed = 2;
  sampling.kind = Sampling::random;  // within faces
  std::vector<SurfacePoint> generators = sample_generators(mesh, sampling);
  SurfacePoint beside = vertex_point(mesh, v);
  for (std::size_t k = 0; k < 3; ++k) beside.bary[k] = (1 - share) * beside.bary[k] + share / 3;
  generators.push_back(beside);
  return generators;
}

/// The inner vertex with the least or largest angle defect.
VertexId extreme_vertex(const IdVector<VertexId, double>& defects, double sign) {
  VertexId best(0);
  for (const VertexId v : defects.ids()) {
    if (sign * defects[v] > sign * defects[best]) best = v;
  }
  return best;
}

TEST_CASE("energy model: its gradient is the derivative of its energy, and that at the state is the energy's") {
  const Mesh mesh = test::make_bumpy_sphere(3, 1);
  const IdVector<VertexId, double> defects = angle_defects(mesh);
  const RelaxationState state = evaluate_state(mesh, generators_beside(mesh, extreme_vertex(defects, -1), 0.1));
  const EnergyModel model(mesh, state, kFree, defects);
  std::mt19937 random(4);
  TangentField step = scaled(test::random_field(12, random), 0.05), way = test::random_field(12, random);
  for (const double along : {-1.0, 0.0, 1.0}) {
    CAPTURE(along);
    const TangentField at = scaled(step, along);
    const double h = 1e-5;
    const double difference =
        (model.at(add_scaled(at, h, way)).change - model.at(add_scaled(at, -h, way)).change) / (2 * h);
    const double slope = dot(model.at(at).gradient, way);
    CHECK(std::abs(difference - slope) < 1e-5 * (1 + std::abs(slope)));
  }
  const ModelEnergy start = model.at(TangentField(12, Vec2::Zero()));
  CHECK(start.change == 0);
  const TangentField gradient = energy_gradient(state);
  CHECK(test::length(add_scaled(gradient, -1, start.gradient)) < 1e-12 * test::length(gradient));
}

TEST_CASE("energy model: its minimum has less energy, keeps the reach, and moves nothing that is held or fixed") {
  const Mesh mesh = test::make_bumpy_sphere(3, 1);
  const IdVector<VertexId, double> defects = angle_defects(mesh);
  std::vector<Freedom> freedom(12, Freedom::free);
  freedom[3] = Freedom::fixed;
  const GeneratorConstraints constraints(mesh, freedom, {});
  const RelaxationState state =
      evaluate_generators(mesh, generators_beside(mesh, VertexId(7), 0.2), {}, {}, constraints);
  const EnergyModel model(mesh, state, constraints, defects);
  for (const double reach : {0.02, 0.1}) {
    CAPTURE(reach);
    const ModelMinimum minimum = model.minimise(reach, 0.1);
    CHECK(minimum.fall > 0);
    CHECK(std::abs(model.at(minimum.step).change + minimum.fall) < 1e-12 * minimum.fall);
    CHECK(minimum.step[3].isZero());
    for (std::size_t i = 0; i < minimum.step.size(); ++i) {
      const bool is_at_vertex = state.generators[i].kind() == SurfacePoint::Kind::vertex;
      CHECK((is_at_vertex || minimum.step[i].norm() <= reach * (1 + 1e-12)));
    }
  }
}

TEST_CASE("energy model: generators that are moved off the saddles where they rest go back there") {
  const Mesh mesh = test::make_bumpy_sphere(4, 1);
  const IdVector<VertexId, double> defects = angle_defects(mesh);
  LloydOptions options;
  options.energy_tolerance = 1e-8;
  const LloydResult limit = relax_generators(mesh, sample_generators(mesh, {.count = 40, .progress = {}}), options);
  Precision precision;
  precision.rest_tolerance = options.move_tolerance;
  const RelaxationState at_rest = evaluate_generators(mesh, limit.generators, precision);
  std::vector<SurfacePoint> beside = limit.generators;
  for (std::size_t i = 0; i < beside.size(); ++i) {
    if (!at_rest.is_resting[i]) continue;
    for (double& coordinate : beside[i].bary) coordinate = 0.94 * coordinate + 0.02;
  }
  const ModelMinimum minimum =
      EnergyModel(mesh, evaluate_generators(mesh, beside, precision), kFree, defects).minimise(0.1, 0.1);
  int resting = 0;
  for (std::size_t i = 0; i < beside.size(); ++i) {
    if (!at_rest.is_resting[i]) continue;
    CAPTURE(i);
    ++resting;
    CHECK(minimum.rest[i] == vertex(mesh, limit.generators[i]));
  }
  CHECK(resting > 0);
}

TEST_CASE("energy model: relaxations near their limit take few diagrams on rough surfaces") {
  std::int64_t diagrams = 0;
  for (unsigned seed = 0; seed < 4; ++seed) {
    const Mesh mesh = test::make_rough_grid(60, 0.1, seed);
    LloydOptions options;
    options.max_iterations = 8;
    const LloydResult near_limit = relax_generators(mesh, test::random_generators(mesh, 12, seed), options);
    options.max_iterations = 300;
    options.energy_tolerance = 1e-8;
    const LloydResult limit = relax_generators(mesh, near_limit.generators, options, {.early_approximation = false});
    CHECK(limit.stop == LloydStop::centroids);
    diagrams += limit.diagrams;
  }
  CAPTURE(diagrams);
  CHECK(diagrams < 15);  // 16 without the cones
}

}  // namespace gvd::test_energy_model
