// Moves of generators, and the tangent vectors that they take along.
#include <cmath>

#include "generator_moves.hpp"
#include "lloyd/states.hpp"
#include "optimiser.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/random.hpp"

namespace gvd::test_generator_moves {

/// Generators whose cells are not known.
RelaxationState state_at(const std::vector<SurfacePoint>& generators, double mean_cell_radius) {
  RelaxationState state;
  state.generators = generators;
  state.rest.resize(generators.size());
  state.mean_cell_radius = mean_cell_radius;
  return state;
}

TEST_CASE("generator moves: lengths of transported vectors and of steps are kept, on every mesh") {
  for (const auto& [name, mesh] : test::small_family()) {
    for (unsigned seed = 0; seed < 3; ++seed) {
      CAPTURE(name, seed);
      std::mt19937 random(seed);
      const auto from = test::random_generators(mesh, 20, seed);
      const TangentField steps = test::random_field(20, random);
      const GeneratorMove move = move_generators(mesh, state_at(from, 1), steps);
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
  const GeneratorMove there = move_generators(mesh, state_at(from, 0.1), steps);
  history.transport(there.turns);
  const GeneratorMove back = move_generators(mesh, state_at(there.to, 0.1), scaled(there.step, -1.0));
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
  const GeneratorMove move = move_generators(mesh, state_at(from, 1), {0.5 * between, -0.5 * between});
  CHECK(move.to == from);
  CHECK(move.held == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(move.length[i] == 0);
    CHECK(move.step[i] == Vec2::Zero());
    CHECK(move.turns[i] == Turn(1, 0));
  }
}

TEST_CASE("generator moves: generators go to rest at their vertex, unless another one is there") {
  const Mesh mesh = test::make_grid(4, 4);
  RelaxationState state =
      state_at({make_surface_point(FaceId(0), {0.9, 0.05, 0.05}), make_surface_point(FaceId(20), {0.3, 0.3, 0.4})}, 1);
  const VertexId corner = mesh.vertices(FaceId(0))[0];
  state.rest[0] = corner;
  const TangentField steps{Vec2(0.01, 0), Vec2(0, 0.01)};
  const GeneratorMove move = move_generators(mesh, state, steps, {}, state.rest);
  CHECK(position(mesh, move.to[0]) == mesh.position(corner));
  CHECK(move.length[0] == Approx((mesh.position(corner) - position(mesh, state.generators[0])).norm()));
  CHECK(move.step[0] == Vec2::Zero());
  CHECK(move.length[1] == Approx(0.01));
  CHECK(position(mesh, move_generators(mesh, state, steps).to[0]) != mesh.position(corner));
  state.generators[1] = vertex_point(mesh, corner);
  CHECK(move_generators(mesh, state, {steps[0], Vec2::Zero()}, {}, state.rest).to[0] == state.generators[0]);
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

/// The point x of a strip along the x axis.
SurfacePoint at(double x) { return edge_point(Mesh::halfedge(FaceId(2 * static_cast<int>(x)), 0), x - std::floor(x)); }

Mesh make_strip() { return test::make_grid(8, 1); }

TEST_CASE("keep apart: no points, one point, and points that did not move") {
  const Mesh mesh = make_strip();
  std::vector<SurfacePoint> none;
  CHECK(keep_apart(mesh, {}, 1, none) == 0);
  std::vector<SurfacePoint> one{at(0.5)};
  CHECK(keep_apart(mesh, {at(3.5)}, 1, one) == 0);
  CHECK(one[0] == at(0.5));
  const std::vector<SurfacePoint> from{at(0.5), at(0.75)};
  std::vector<SurfacePoint> to = from;
  CHECK(keep_apart(mesh, from, 1, to) == 0);  // closer than the gap, but neither has moved
  CHECK(to == from);
}

TEST_CASE("keep apart: both of two points that collide go back, or the one that has moved") {
  const Mesh mesh = make_strip();
  const std::vector<SurfacePoint> from{at(1.5), at(3.5), at(6.5)};
  std::vector<SurfacePoint> to{at(2.5), at(2.55), at(5.5)};
  CHECK(keep_apart(mesh, from, 0.1, to) == 2);
  CHECK(to == std::vector<SurfacePoint>{from[0], from[1], at(5.5)});
  to = {at(1.5), at(1.55), at(6.5)};
  CHECK(keep_apart(mesh, from, 0.1, to) == 1);
  CHECK(to == from);
}

TEST_CASE("keep apart: a point that goes back may push the next one back") {
  const Mesh mesh = make_strip();
  // Each of the points has moved to where the one before it comes from; the last one collides with a fixed one.
  const std::vector<SurfacePoint> from{at(0.5), at(1.5), at(2.5), at(3.5), at(7.5)};
  std::vector<SurfacePoint> to{at(1.5), at(2.5), at(3.5), at(7.45), at(7.5)};
  CHECK(keep_apart(mesh, from, 0.1, to) == 4);
  CHECK(to == from);
}

TEST_CASE("keep apart: after it, no moved point is within the gap of another one") {
  const Mesh mesh = test::make_sphere(2);
  test::Random random(7);
  const auto draw = [&] {
    const double u = random.real(0.05, 0.9), v = (1 - u) * random.real(0.05, 0.95);
    return make_surface_point(FaceId(random.below(mesh.face_count())), {u, v, 1 - u - v});
  };
  for (const double gap : {0.05, 0.2}) {
    std::vector<SurfacePoint> from, to;
    while (from.size() < 40) {
      const SurfacePoint p = draw();
      const auto near = [&](const SurfacePoint& q) { return (position(mesh, p) - position(mesh, q)).norm() <= gap; };
      if (std::none_of(from.begin(), from.end(), near)) from.push_back(p);
    }
    for (std::size_t i = 0; i < from.size(); ++i) to.push_back(draw());
    const std::vector<SurfacePoint> wanted = to;
    const std::int32_t undone = keep_apart(mesh, from, gap, to);
    std::int32_t at_start = 0;
    for (std::size_t i = 0; i < to.size(); ++i) {
      CHECK((to[i] == wanted[i] || to[i] == from[i]));
      at_start += to[i] == from[i];
      for (std::size_t k = 0; k < i; ++k) CHECK((position(mesh, to[i]) - position(mesh, to[k])).norm() > gap);
    }
    CHECK(undone == at_start);
  }
}

}  // namespace gvd::test_generator_moves
