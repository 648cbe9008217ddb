// Moves of generators, and the tangent vectors that they take along.
#include <cmath>

#include "lloyd/random_field.hpp"
#include "optimiser/step_history.hpp"
#include "state/generator_moves.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

using namespace gvd;

TEST_CASE("generator moves: lengths of transported vectors and of steps are kept, on every mesh") {
  for (const auto& [name, mesh] : test::small_family()) {
    for (unsigned seed = 0; seed < 3; ++seed) {
      CAPTURE(name, seed);
      std::mt19937 random(seed);
      const auto from = test::random_generators(mesh, 20, seed);
      const TangentField steps = test::random_field(20, random);
      const GeneratorMove move = move_generators(mesh, from, steps, 1);
      REQUIRE(move.to.size() == 20);
      for (std::size_t i = 0; i < 20; ++i) {
        CHECK(move.turns[i].norm() == Approx(1).epsilon(1e-9));
        CHECK(move.step[i].norm() == Approx(move.length[i]).epsilon(1e-9).margin(1e-12));
        CHECK(move.length[i] <= steps[i].norm() * (1 + 1e-9));
        // The path keeps its direction: the turn takes the step to the step seen from the end.
        const Vec2 carried = turned(move.turns[i], steps[i].normalized()) * move.length[i];
        CHECK((carried - move.step[i]).norm() < 1e-9);
      }
    }
  }
}

TEST_CASE("generator moves: there and back again, transported vectors return") {
  const Mesh mesh = test::make_bumpy_sphere(3, 5);
  std::mt19937 random(1);
  const auto from = test::random_generators(mesh, 30, 1);
  TangentField steps = test::random_field(30, random);
  for (Vec2& s : steps) s *= 0.2;
  StepHistory history(3);
  const TangentField first = test::random_field(30, random);
  history.add({first, steps});
  const GeneratorMove there = move_generators(mesh, from, steps, 0.1);
  history.transport(there.turns);
  const GeneratorMove back =
      move_generators(mesh, there.to, add_scaled(TangentField(30, Vec2::Zero()), -1, there.step), 0.1);
  history.transport(back.turns);
  for (std::size_t i = 0; i < 30; ++i) {
    if (from[i].kind() != SurfacePoint::Kind::face || back.to[i].face != from[i].face) continue;  // another plane
    CHECK((history.pairs()[0].step[i] - first[i]).norm() < 1e-6);
    CHECK((history.pairs()[0].change[i] - steps[i]).norm() < 1e-6);
  }
}

TEST_CASE("generator moves: generators that would collide stay, with neither length nor turn") {
  const Mesh mesh = test::make_grid(4, 4);
  const std::vector<SurfacePoint> from{make_surface_point(FaceId(0), {0.5, 0.3, 0.2}),
                                       make_surface_point(FaceId(0), {0.3, 0.5, 0.2})};
  const Vec2 between = {(position(mesh, from[1]) - position(mesh, from[0])).norm(), 0};
  const GeneratorMove move = move_generators(mesh, from, {0.5 * between, -0.5 * between}, 1);
  CHECK(move.to == from);
  CHECK(move.held == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(move.length[i] == 0);
    CHECK(move.step[i] == Vec2::Zero());
    CHECK(move.turns[i] == Turn(1, 0));
  }
}

TEST_CASE("step history: the oldest pairs are dropped") {
  StepHistory history(2);
  for (double i = 0; i < 4; ++i) history.add({{Vec2(i, 0)}, {Vec2(0, i)}});
  REQUIRE(history.pairs().size() == 2);
  CHECK(history.pairs()[0].step[0] == Vec2(2, 0));
  CHECK(history.pairs()[1].change[0] == Vec2(0, 3));
  history.clear();
  CHECK(history.pairs().empty());
}
