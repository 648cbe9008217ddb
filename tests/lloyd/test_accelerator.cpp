// The Hessian of the energy against differences of the gradient, and its inverse.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "accelerator.hpp"
#include "energy_hessian.hpp"
#include "generator_moves.hpp"
#include "gvd/sampling.hpp"
#include "lloyd/states.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

namespace gvd::test_accelerator {

using test::evaluate_state;
using test::make_rough_grid;

/// The change of the gradient by a step, in the tangent planes at its start.
TangentField gradient_change(const Mesh& mesh, const RelaxationState& state, const TangentField& step) {
  const auto at = [&](double factor) {
    const TangentField scaled = add_scaled(TangentField(step.size(), Vec2::Zero()), factor, step);
    const GeneratorMove move = move_generators(mesh, state, scaled);
    std::vector<Turn> back = move.turns;
    for (Turn& turn : back) turn.y() = -turn.y();
    return turned(back, energy_gradient(evaluate_state(mesh, move.to)));
  };
  TangentField change = add_scaled(at(0.5), -1, at(-0.5));
  return change;
}

EnergyHessian hessian(const Mesh& mesh, const RelaxationState& state) { return {state, angle_defects(mesh), 0}; }

std::vector<SurfacePoint> in_faces(const Mesh& mesh, int count, std::uint64_t seed) {
  SamplingOptions sampling;
  sampling.count = count;
  sampling.seed = seed;
  sampling.kind = Sampling::random;
  return sample_generators(mesh, sampling);
}

TEST_CASE("energy hessian: in the plane it is the derivative of the gradient") {
  const Mesh mesh = test::make_grid(9, 8);
  for (unsigned seed = 0; seed < 4; ++seed) {
    CAPTURE(seed);
    const RelaxationState state = evaluate_state(mesh, in_faces(mesh, 12, seed));
    std::mt19937 random(seed);
    TangentField step = test::random_field(12, random);
    for (Vec2& s : step) s *= 1e-3;
    const TangentField change = gradient_change(mesh, state, step);
    const TangentField product = hessian(mesh, state).multiply(step);
    CHECK(test::length(add_scaled(product, -1, change)) < 1e-3 * test::length(change));
  }
}

TEST_CASE("energy hessian: on a sphere with small cells it is near the derivative") {
  const Mesh mesh = test::make_sphere(4);
  const RelaxationState state = evaluate_state(mesh, in_faces(mesh, 120, 3));
  std::mt19937 random(3);
  TangentField step = test::random_field(120, random);
  for (Vec2& s : step) s *= 1e-3;
  const TangentField change = gradient_change(mesh, state, step);
  const TangentField product = hessian(mesh, state).multiply(step);
  CHECK(test::length(add_scaled(product, -1, change)) < 0.08 * test::length(change));
}

TEST_CASE("energy hessian: on rough meshes what vertices bend makes it more exact") {
  double with = 0, without = 0;
  for (unsigned seed = 0; seed < 6; ++seed) {
    const Mesh mesh = make_rough_grid(40, 0.1, seed);
    const RelaxationState state = evaluate_state(mesh, in_faces(mesh, 12, seed));
    std::mt19937 random(seed);
    TangentField step = test::random_field(12, random);
    for (Vec2& s : step) s *= 0.02;
    const TangentField change = gradient_change(mesh, state, step);
    const auto error = [&](const IdVector<VertexId, double>& defects) {
      const TangentField product = EnergyHessian(state, defects, 0.02).multiply(step);
      return test::length(add_scaled(product, -1, change)) / test::length(change);
    };
    with += error(angle_defects(mesh));
    without += error(IdVector<VertexId, double>(mesh.vertex_count(), 0));
  }
  CAPTURE(with, without);
  CHECK(with < 0.75 * without);
}

TEST_CASE("angle defects: they add up to 4 pi on a sphere, and are 0 on boundaries and in a plane") {
  double sum = 0;
  for (const double defect : angle_defects(test::make_bumpy_sphere(3, 1))) sum += defect;
  CHECK(std::abs(sum - 4 * std::numbers::pi) < 1e-9);
  for (const double defect : angle_defects(test::make_grid(5, 4))) CHECK(std::abs(defect) < 1e-12);
}

TEST_CASE("energy hessian: solved for the gradient it gives a direction of descent, on every mesh") {
  for (const auto& [name, mesh] : test::small_family()) {
    for (unsigned seed = 0; seed < 3; ++seed) {
      CAPTURE(name, seed);
      const RelaxationState state = evaluate_state(mesh, test::random_generators(mesh, 15, seed));
      const TangentField gradient = energy_gradient(state);
      const TangentField step = hessian(mesh, state).solve(gradient, 0.1);
      CHECK(dot(step, gradient) > 0);
      double longest = 0, way = 0;
      for (std::size_t i = 0; i < step.size(); ++i) {
        longest = std::max(longest, step[i].norm());
        way += state.to_centroids[i].norm();
      }
      CHECK(longest <= 100 * way);
    }
  }
}

TEST_CASE("energy hessian: a single generator has no bisectors, so its inverse is that of the mass") {
  const Mesh mesh = test::make_grid(6, 4);
  const RelaxationState state = evaluate_state(mesh, in_faces(mesh, 1, 5));
  const TangentField step = hessian(mesh, state).solve(energy_gradient(state), 0.1);
  CHECK((step[0] + state.to_centroids[0]).norm() < 1e-12);
}

}  // namespace gvd::test_accelerator
