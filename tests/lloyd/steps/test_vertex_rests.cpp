// Generators that rest at vertices, where the energy has no gradient that vanishes.
#include <numbers>

#include "gvd/lloyd.hpp"
#include "lloyd/evaluate_state.hpp"
#include "steps/vertex_rests.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

using namespace gvd;
using test::evaluate_state;

namespace {

/// A disc round vertex 0, whose rim rises and falls: 6 turns of a height, the higher the more angle about the vertex.
Mesh make_saddle(double height) {
  std::vector<Vec3> positions = {{0, 0, 0}};
  std::vector<std::array<int, 3>> faces;
  const int sides = 12;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    positions.push_back({std::cos(angle), std::sin(angle), i % 2 == 0 ? height : -height});
    faces.push_back({0, 1 + i, 1 + (i + 1) % sides});
  }
  return test::make_mesh(positions, faces);
}

bool rests_at(const Mesh& mesh, VertexId v) {
  RelaxationState state = evaluate_state(mesh, {vertex_point(mesh, v)});
  CellIntegrals integrals(mesh);
  mark_rests(mesh, 0.001 * state.mean_cell_radius, integrals, state);
  CHECK((state.is_resting[0] != 0) == (state.to_centroids[0] == Vec2::Zero()));
  return state.is_resting[0] != 0;
}

}  // namespace

TEST_CASE("vertex rests: a generator rests at a saddle, not at the tip of a cone, nor at a corner of a square") {
  CHECK(rests_at(make_saddle(0.3), VertexId(0)));
  CHECK(rests_at(make_saddle(2), VertexId(0)));
  CHECK_FALSE(rests_at(test::make_pyramid(270, 12), VertexId(0)));
  CHECK_FALSE(rests_at(test::make_grid(4, 4), VertexId(0)));
}

TEST_CASE("vertex rests: a saddle on the way to the centroid is found, and other vertices are not") {
  const Mesh mesh = make_saddle(0.3);
  CellIntegrals integrals(mesh);
  const RelaxationState beside = evaluate_state(mesh, {make_surface_point(FaceId(3), {0.98, 0.01, 0.01})});
  const std::vector<Rest> rests = find_rests(mesh, beside, 0.001 * beside.mean_cell_radius, integrals);
  REQUIRE(rests.size() == 1);
  CHECK(rests[0].generator == 0);
  CHECK(rests[0].vertex == VertexId(0));
  const Mesh flat = test::make_grid(4, 4);
  const RelaxationState plain = evaluate_state(flat, {make_surface_point(FaceId(13), {0.8, 0.1, 0.1})});
  CHECK(find_rests(flat, plain, 1e-6, integrals).empty());
}

TEST_CASE("vertex rests: relaxation ends at the saddle, whichever side it starts from") {
  for (const double height : {0.2, 0.5, 1.0}) {
    const Mesh mesh = make_saddle(height);
    for (int face = 0; face < mesh.face_count(); ++face) {
      CAPTURE(height, face);
      LloydOptions options;
      options.energy_tolerance = 0;
      const LloydResult result = relax_generators(mesh, {make_surface_point(FaceId(face), {0.7, 0.2, 0.1})}, options);
      CHECK(result.stop == LloydStop::centroids);
      CHECK(result.residual == 0);
      CHECK(position(mesh, result.generators[0]).norm() < 1e-12);
    }
  }
}

TEST_CASE("vertex rests: a generator does not go where another one is") {
  const Mesh mesh = make_saddle(0.3);
  const std::vector<SurfacePoint> from{make_surface_point(FaceId(3), {0.8, 0.1, 0.1}),
                                       make_surface_point(FaceId(9), {0.8, 0.1, 0.1})};
  GeneratorMove move = move_generators(mesh, from, {Vec2(0.01, 0), Vec2(0, 0.01)}, 1);
  const GeneratorMove before = move;
  move_to_rest(mesh, {0, VertexId(0)}, 1, from, move);
  CHECK(move.to == before.to);
  move_to_rest(mesh, {0, VertexId(0)}, 0.001, from, move);
  CHECK(position(mesh, move.to[0]) == Vec3(0, 0, 0));
  CHECK(move.to[1] == before.to[1]);
  CHECK(move.length[0] == Approx(position(mesh, from[0]).norm()));
}
