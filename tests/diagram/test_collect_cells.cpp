// From a traced diagram to cells: areas, pieces, labels of faces, neighbours.
#include <algorithm>
#include <cstdint>
#include <map>
#include <vector>

#include "base/barycentric.hpp"
#include "diagram/collect_cells.hpp"
#include "diagram/trace_bisectors.hpp"
#include "gvd/mesh.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/random.hpp"
#include "support/same_diagram.hpp"
#include "support/stages.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_collect_cells {

Diagram collect(const Mesh& mesh, const std::vector<SurfacePoint>& generators, int threads = 1) {
  const Progress silent;
  const ParallelChunks parallel(threads, silent);
  const WorkingMesh working(mesh, generators);
  const FastMarchingResult marched = march(working, Front::circle, {});
  const TracedDiagram traced = test::trace_growth(working, marched.table, Front::circle);
  Diagram diagram;
  trace_bisectors(working, traced, parallel, diagram);
  collect_cells(working, traced, parallel, diagram);
  return diagram;
}

const Cell& cell(const Diagram& diagram, int g) { return diagram.cells[GeneratorId(g)]; }

TEST_CASE("one face, one generator at a corner: the face is labelled, and there is no piece") {
  const Mesh mesh = test::make_triangle();
  const Diagram diagram = collect(mesh, test::at_vertices(mesh, {1}));
  REQUIRE(diagram.cells.size() == 1);
  CHECK(cell(diagram, 0).generator == GeneratorId(0));
  CHECK(cell(diagram, 0).area == Approx(mesh.area(FaceId(0))).epsilon(1e-15));
  CHECK(cell(diagram, 0).euler_characteristic == 1);
  CHECK(cell(diagram, 0).components == 1);
  CHECK(cell(diagram, 0).boundary_loops == 1);
  CHECK(cell(diagram, 0).neighbours.empty());
  CHECK(diagram.face_label.raw() == std::vector<GeneratorId>{GeneratorId(0)});
  CHECK(diagram.pieces.empty());
}

TEST_CASE("a generator inside a face splits it: its pieces cover the face, which has no label") {
  const Mesh mesh = test::make_triangle();
  const Diagram diagram = collect(mesh, {make_surface_point(FaceId(0), {0.2, 0.3, 0.5})});
  CHECK_FALSE(diagram.face_label[FaceId(0)].valid());
  REQUIRE(diagram.pieces.size() == 3);
  double share = 0;
  for (const FacePiece& piece : diagram.pieces) {
    CHECK(piece.face == FaceId(0));
    CHECK(piece.generator == GeneratorId(0));
    share += area_share(piece.corners);
  }
  CHECK(share == Approx(1).epsilon(1e-14));
  CHECK(cell(diagram, 0).area == Approx(mesh.area(FaceId(0))).epsilon(1e-14));
}

TEST_CASE("two generators on a pillow: two discs with half of the area each, neighbours of each other") {
  const Mesh mesh = test::make_pillow();
  const Diagram diagram =
      collect(mesh, {make_surface_point(FaceId(0), {0.3, 0.3, 0.4}), make_surface_point(FaceId(1), {0.3, 0.4, 0.3})});
  for (const int g : {0, 1}) {
    CHECK(cell(diagram, g).area == Approx(mesh.area(FaceId(0))).epsilon(0.05));
    CHECK(cell(diagram, g).euler_characteristic == 1);
    CHECK(cell(diagram, g).boundary_loops == 1);
    CHECK(cell(diagram, g).neighbours == std::vector<GeneratorId>{GeneratorId(1 - g)});
  }
  CHECK(cell(diagram, 0).area + cell(diagram, 1).area == Approx(compute_area(mesh)).epsilon(1e-14));
}

TEST_CASE("a component without a generator has neither labels nor pieces") {
  const Mesh mesh = test::make_two_components();
  const Diagram diagram = collect(mesh, test::at_vertices(mesh, {0}));
  std::size_t labelled = 0;
  for (const GeneratorId g : diagram.face_label) labelled += g.valid() ? 1 : 0;
  CHECK(labelled > 0);
  CHECK(labelled < diagram.face_label.size());
  CHECK(cell(diagram, 0).area < compute_area(mesh));
}

TEST_CASE("faces are labelled or cut, never both, and the cells' areas are those of their faces and pieces") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    const Diagram diagram = collect(mesh, test::random_generators(mesh, 40, 31));
    REQUIRE(diagram.face_label.size() == static_cast<std::size_t>(mesh.face_count()));
    REQUIRE(std::is_sorted(diagram.pieces.begin(), diagram.pieces.end(),
                           [](const FacePiece& a, const FacePiece& b) { return a.face < b.face; }));
    IdVector<GeneratorId, double> area(diagram.cells.size(), 0.0);
    for (int f = 0; f < mesh.face_count(); ++f) {
      const GeneratorId g = diagram.face_label[FaceId(f)];
      if (g.valid()) area[g] += mesh.area(FaceId(f));
    }
    for (const FacePiece& piece : diagram.pieces) {
      REQUIRE_FALSE(diagram.face_label[piece.face].valid());
      area[piece.generator] += area_share(piece.corners) * mesh.area(piece.face);
    }
    for (const Cell& c : diagram.cells)
      REQUIRE(c.area == Approx(area[c.generator]).epsilon(1e-9).margin(1e-9 * compute_area(mesh)));
  }
}

TEST_CASE("neighbours are listed once, in ascending order, and without the cell itself") {
  const Mesh mesh = test::make_torus(24, 12);
  const Diagram diagram = collect(mesh, test::random_generators(mesh, 15, 32));
  for (const Cell& c : diagram.cells) {
    REQUIRE_FALSE(c.neighbours.empty());
    REQUIRE(std::adjacent_find(c.neighbours.begin(), c.neighbours.end(),
                               [](GeneratorId a, GeneratorId b) { return a >= b; }) == c.neighbours.end());
    REQUIRE_FALSE(std::binary_search(c.neighbours.begin(), c.neighbours.end(), c.generator));
  }
}

TEST_CASE("cells are the same on one thread and on three, to the last bit") {
  const Mesh mesh = test::make_sphere(4);
  const auto generators = test::random_generators(mesh, 500, 33);
  CHECK(test::same_diagram(collect(mesh, generators, 1), collect(mesh, generators, 3)));
}

TEST_CASE("no cell asked for: no share") { CHECK(CellShares().take().empty()); }

TEST_CASE("a share begins at zero, and is the same one when it is asked for again") {
  CellShares shares;
  CHECK(shares[GeneratorId(7)].euler_characteristic == 0);
  CHECK(shares[GeneratorId(7)].area == 0);
  shares[GeneratorId(7)].area += 2;
  shares[GeneratorId(3)].area += 1;
  shares[GeneratorId(7)].area += 2;
  const std::vector<CellShare> all = shares.take();
  REQUIRE(all.size() == 2);
  CHECK(all[0].generator == GeneratorId(7));
  CHECK(all[0].area == 4);
  CHECK(all[1].generator == GeneratorId(3));
  CHECK(all[1].area == 1);
}

TEST_CASE("many cells, in any order, sum up as in an ordered map, and come out in the order of insertion") {
  test::Random random(5);
  for (const int cells : {1, 2, 16, 17, 1000}) {
    CAPTURE(cells);
    CellShares shares;
    std::map<GeneratorId, int> expected;
    std::vector<GeneratorId> order;
    for (int i = 0; i < 5000; ++i) {
      const GeneratorId g(1000003 * random.below(cells));  // far apart
      if (++expected[g] == 1) order.push_back(g);
      ++shares[g].euler_characteristic;
    }
    const std::vector<CellShare> all = shares.take();
    REQUIRE(all.size() == order.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      REQUIRE(all[i].generator == order[i]);
      REQUIRE(all[i].euler_characteristic == expected[order[i]]);
    }
  }
}

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

}  // namespace gvd::test_collect_cells
