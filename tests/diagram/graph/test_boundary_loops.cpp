#include <cstdint>
#include <vector>

#include "diagram/graph/boundary_loops.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/stages.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_boundary_loops {

std::vector<std::int32_t> count_loops(const Mesh& mesh, const std::vector<SurfacePoint>& generators) {
  const WorkingMesh working(mesh, generators);
  const FastMarchingResult marched = march(working, Front::circle, {});
  return count_boundary_loops(working, test::trace_growth(working, marched.table, Front::circle)).raw();
}

std::vector<std::int32_t> count_loops_at(const Mesh& mesh, const std::vector<int>& generators) {
  return count_loops(mesh, test::at_vertices(mesh, generators));
}

using Counts = std::vector<std::int32_t>;

TEST_CASE("one generator: the loops are those of the mesh's boundary") {
  CHECK(count_loops_at(test::make_triangle(), {0}) == Counts{1});
  CHECK(count_loops_at(test::make_pillow(), {0}) == Counts{0});
  CHECK(count_loops_at(test::make_sphere(2), {0}) == Counts{0});
  CHECK(count_loops_at(test::make_grid(3, 3), {5}) == Counts{1});
  CHECK(count_loops_at(test::make_ring(24, 6), {10}) == Counts{2});
  CHECK(count_loops_at(test::make_half_sphere(2), {0}) == Counts{1});
}

TEST_CASE("a component without a generator counts for no cell") {
  CHECK(count_loops_at(test::make_two_components(), {0}) == Counts{0});
}

TEST_CASE("a closed bisector is a loop of both of its cells") {
  CHECK(count_loops_at(test::make_sphere(3), {0, 3}) == Counts{1, 1});
  CHECK(count_loops_at(test::make_torus(24, 12), {0, 12 * 12}) == Counts{2, 2});
}

TEST_CASE("where bisectors end on the mesh's boundary, they form one loop with its pieces") {
  CHECK(count_loops_at(test::make_grid(6, 6), {0, 48}) == Counts{1, 1});
  CHECK(count_loops_at(test::make_ring(24, 6), {3, 12 * 7 + 3}) == Counts{1, 1});
}

TEST_CASE("branch points join the bisectors round a cell to one loop") {
  CHECK(count_loops_at(test::make_tetrahedron(), {0, 1, 2, 3}) == Counts{1, 1, 1, 1});
  const Mesh mesh = test::make_sphere(3);
  for (const std::int32_t loops : count_loops(mesh, test::random_generators(mesh, 40, 3))) CHECK(loops >= 1);
}

}  // namespace gvd::test_boundary_loops
