// Whole placements: features are met, fixed vertices stay, and the result depends on no thread.
#include <algorithm>

#include "gvd/error.hpp"
#include "gvd/placement.hpp"
#include "gvd/remesh.hpp"
#include "placement/crease_cells.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

using namespace gvd;

namespace {

RemeshResult remesh_at_generators(const Mesh& mesh, int count) {
  RemeshOptions options;
  options.placement.method = Placement::generator;
  return remesh(mesh, test::random_generators(mesh, count, 1), options);
}

std::vector<Vec3> place(const Mesh& mesh, const RemeshResult& result, const PlacementOptions& options) {
  return place_vertices(mesh, result.diagram, result.mesh, result.face_points, options);
}

}  // namespace

TEST_CASE("the rim of a plate is met: the distances fall by more than on smooth surfaces") {
  const Mesh mesh = test::make_plate(12, 0.2);
  const RemeshResult before = remesh_at_generators(mesh, 120);
  for (const Placement method : {Placement::quadric, Placement::fit}) {
    PlacementOptions options;
    options.method = method;
    const RemeshResult after = [&] {
      RemeshOptions all;
      all.placement = options;
      return remesh(mesh, before.generators, all);
    }();
    CHECK(after.input_to_output.rms < 0.6 * before.input_to_output.rms);
    CHECK(after.mesh.positions() == place(mesh, before, options));
  }
}

TEST_CASE("fixed vertices stay at their generators") {
  const Mesh mesh = test::make_bumpy_sphere(3, 1);
  const RemeshResult before = remesh_at_generators(mesh, 40);
  PlacementOptions options;
  options.fixed = {GeneratorId(0), GeneratorId(7)};
  const std::vector<Vec3> placed = place(mesh, before, options);
  int moved = 0;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const bool stays = placed[i] == before.mesh.positions()[i];
    if (i == 0 || i == 7) CHECK(stays);
    moved += !stays;
  }
  CHECK(moved > 30);
}

TEST_CASE("placements do not depend on the number of threads") {
  const Mesh mesh = test::make_bumpy_sphere(3, 1);
  const RemeshResult before = remesh_at_generators(mesh, 60);
  PlacementOptions one, many;
  one.threads = 1;
  many.threads = 3;
  CHECK(place(mesh, before, one) == place(mesh, before, many));
}

TEST_CASE("a remesh of another diagram is refused") {
  const Mesh mesh = test::make_sphere(2);
  const RemeshResult a = remesh_at_generators(mesh, 10), b = remesh_at_generators(mesh, 12);
  CHECK_THROWS_AS(place_vertices(mesh, a.diagram, b.mesh, b.face_points), Error);
}

TEST_CASE("cells with a share of a sharp edge or of the boundary are found") {
  const auto count_cells = [](const Mesh& mesh) {
    const auto found = find_crease_cells(mesh, compute_diagram(mesh, test::random_generators(mesh, 50, 1)));
    return std::count(found.begin(), found.end(), 1);
  };
  CHECK(count_cells(test::make_sphere(3)) == 0);
  CHECK(count_cells(test::make_torus(24, 12)) == 0);
  const auto on_grid = count_cells(test::make_grid(12, 12));
  CHECK((on_grid > 10 && on_grid < 40));
  CHECK(count_cells(test::make_plate(8, 0.3)) > 20);
}
