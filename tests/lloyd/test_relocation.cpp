// Generators that leave cells with little energy for distant cells with much.
#include <algorithm>
#include <array>
#include <set>
#include <utility>
#include <vector>

#include "generator_moves.hpp"
#include "gvd/check.hpp"
#include "gvd/lloyd.hpp"
#include "lloyd/states.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

namespace gvd::test_relocation {

using test::evaluate_state;

/// `count` generators in one face.
std::vector<SurfacePoint> clustered(FaceId face, int count) {
  std::vector<SurfacePoint> points;
  for (int i = 0; i < count; ++i) {
    const double u = 0.1 + 0.5 * (i + 0.5) / count, v = 0.1 + 0.05 * (i % 3);
    points.push_back(make_surface_point(face, {u, v, 1 - u - v}));
  }
  return points;
}

TEST_CASE("relocation: a clustered start is evened out, and only far better places are taken") {
  const Mesh mesh = test::make_sphere(3);
  const RelaxationState state = evaluate_state(mesh, clustered(FaceId(17), 20));
  const std::vector<Relocation> plan = plan_relocations(mesh, {}, state);
  REQUIRE_FALSE(plan.empty());
  const GeneratorMove move = relocate_generators(mesh, state, plan, plan.size());
  CHECK(move.relocated == static_cast<std::int32_t>(plan.size()));
  CHECK(evaluate_state(mesh, move.to).energy < state.energy);
  for (const Relocation& relocation : plan) CHECK(relocation.gain > 0);
}

TEST_CASE("relocation: nobody leaves twice, shares a place, leaves a large hole, or changes the component") {
  for (const auto& [name, mesh] : test::small_family()) {
    for (unsigned seed = 0; seed < 3; ++seed) {
      CAPTURE(name, seed);
      const RelaxationState state = evaluate_state(mesh, test::random_generators(mesh, 30, seed));
      const auto components = compute_face_components(mesh);
      std::set<std::size_t> leaving;
      std::set<VertexId> places;
      double given_up = 0;
      std::vector<double> area(2), cells(2);
      for (std::size_t i = 0; i < 30; ++i) {
        const auto component = static_cast<std::size_t>(components[state.generators[i].face]);
        area[component] += state.moments[GeneratorId(i)].area;
        cells[component] += 1;
      }
      for (const Relocation& relocation : plan_relocations(mesh, {}, state)) {
        const CellMoments& cell = state.moments[GeneratorId(relocation.generator)];
        CHECK(leaving.insert(relocation.generator).second);
        CHECK(places.insert(vertex(mesh, relocation.to)).second);
        CHECK(components[state.generators[relocation.generator].face] == components[relocation.to.face]);
        const auto component = static_cast<std::size_t>(components[relocation.to.face]);
        CHECK(cell.area <= 0.51 * area[component] / cells[component]);
        given_up += cell.area;
      }
      CHECK(given_up < 0.5 * (area[0] + area[1]));
    }
  }
}

TEST_CASE("relocation: far places of one component do not keep others from theirs") {
  // A small square with a cluster, and a large one with a single generator.
  const Mesh small = test::make_grid(12, 12), large = test::make_grid(4, 4);
  std::vector<Vec3> positions = small.positions();
  std::vector<std::array<VertexId, 3>> faces;
  for (int f = 0; f < small.face_count(); ++f) faces.push_back(small.vertices(FaceId(f)));
  for (const Vec3& p : large.positions()) positions.push_back(20 * p + Vec3(100, 0, 0));
  for (int f = 0; f < large.face_count(); ++f) {
    const auto& [a, b, c] = large.vertices(FaceId(f));
    const int first = small.vertex_count();
    faces.push_back({VertexId(a.value() + first), VertexId(b.value() + first), VertexId(c.value() + first)});
  }
  const Mesh mesh(std::move(positions), std::move(faces));
  std::vector<SurfacePoint> generators = clustered(FaceId(30), 24);
  generators.push_back(make_surface_point(FaceId(small.face_count() + 3), {0.3, 0.3, 0.4}));
  const std::vector<Relocation> plan = plan_relocations(mesh, {}, evaluate_state(mesh, generators));
  CHECK(plan.size() >= 5);
  for (const Relocation& relocation : plan) CHECK(relocation.to.face.value() < small.face_count());
}

TEST_CASE("relocation: plans save more than they promise, on the average") {
  // After two iterations clusters are gone, and what the given-up cells cost counts as much as what the new ones save.
  double promised = 0, saved = 0;
  for (const auto& [name, mesh] : test::small_family()) {
    for (unsigned seed = 0; seed < 2; ++seed) {
      LloydOptions options;
      options.max_iterations = 2;
      options.relocate = false;
      options.acceleration = Acceleration::none;
      const LloydResult start = relax_generators(mesh, test::random_generators(mesh, 60, seed), options);
      const RelaxationState state = evaluate_state(mesh, start.generators);
      const std::vector<Relocation> plan = plan_relocations(mesh, {}, state);
      const GeneratorMove move = relocate_generators(mesh, state, plan, plan.size());
      promised += total_gain(plan) / state.energy;
      saved += 1 - evaluate_state(mesh, move.to).energy / state.energy;
    }
  }
  CHECK(promised > 0.05);
  CHECK(saved > promised);
}

TEST_CASE("relocation: relaxed generators stay where they are") {
  const Mesh mesh = test::make_torus(24, 12);
  const LloydResult relaxed = relax_generators(mesh, test::random_generators(mesh, 12, 2));
  CHECK(plan_relocations(mesh, {}, evaluate_state(mesh, relaxed.generators)).empty());
}

TEST_CASE("relocation: from one face, generators spread over the surface in a few iterations") {
  for (const auto& [name, mesh] : test::small_family()) {
    if (name == "two components") continue;  // no generator changes its component
    CAPTURE(name);
    const auto relax = [&mesh = mesh](const std::vector<SurfacePoint>& start, bool relocate) {
      LloydOptions options;
      options.relocate = relocate;
      options.max_iterations = 3;
      return relax_generators(mesh, start, options);
    };
    const std::vector<SurfacePoint> cluster = clustered(FaceId(17), 60);
    const LloydResult moved = relax(cluster, true), stuck = relax(cluster, false);
    CHECK(moved.final_energy < 0.8 * stuck.final_energy);
    CHECK(check_diagram(mesh, moved.diagram).ok());
    double before = moved.initial_energy;
    for (const LloydIteration& i : moved.iterations) {
      CHECK(i.energy < before);
      before = i.energy;
    }
    for (const LloydIteration& i : stuck.iterations) CHECK(i.relocated == 0);
  }
}

}  // namespace gvd::test_relocation
