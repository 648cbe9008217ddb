// The row of propose_generators.hpp's table for each property, on the smallest mesh and with diagrams made by hand.
#include <array>
#include <cmath>
#include <vector>

#include "repair/repair_defect.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_repair_defect {

const GeneratorId kA(0), kB(1), kC(2);

/// One triangle with the corners (0, 0), (8, 0) and (0, 8).
Mesh make_face() { return test::make_mesh({{0, 0, 0}, {8, 0, 0}, {0, 8, 0}}, {{0, 1, 2}}); }

SurfacePoint at(double x, double y) { return make_surface_point(FaceId(0), {1 - x / 8 - y / 8, x / 8, y / 8}); }

DualDefect make_defect(DualProperty property, std::vector<GeneratorId> cells = {}) {
  DualDefect defect;
  defect.property = property;
  defect.cells = std::move(cells);
  return defect;
}

struct Setup {
  explicit Setup(Mesh of_mesh, std::vector<SurfacePoint> generators = {}) : mesh(std::move(of_mesh)) {
    diagram.generators = std::move(generators);
    diagram.vertex_label.assign(static_cast<std::size_t>(mesh.vertex_count()), GeneratorId());
    diagram.vertex_distance.assign(static_cast<std::size_t>(mesh.vertex_count()), 0);
  }

  void label_vertex(int v, GeneratorId g, double distance) {
    diagram.vertex_label[VertexId(v)] = g;
    diagram.vertex_distance[VertexId(v)] = distance;
  }
  BisectorId add_bisector(GeneratorId left, GeneratorId right, std::vector<SurfacePoint> points, bool closed = false) {
    return diagram.bisectors.push_back({left, right, closed, {}, std::move(points)});
  }
  BranchPointId add_branch(const SurfacePoint& p, std::vector<GeneratorId> generators) {
    return diagram.branch_points.push_back({p, position(mesh, p), std::move(generators)});
  }

  std::vector<SurfacePoint> repair(const DualDefect& defect) const {
    AddedGenerators added(mesh, diagram.generators, 100);
    DefectRepair(mesh, diagram, added).repair(defect);
    return added.take();
  }
  std::vector<SurfacePoint> repair_bisector(BisectorId b) const {
    DualDefect defect = make_defect(DualProperty::bisector_has_face);
    defect.bisector = b;
    return repair(defect);
  }
  std::vector<SurfacePoint> repair_branch(DualProperty property, BranchPointId b) const {
    DualDefect defect = make_defect(property);
    defect.branch_point = b;
    return repair(defect);
  }

  Mesh mesh;
  Diagram diagram;
};

using Points = std::vector<SurfacePoint>;

TEST_CASE("a component without a generator gets its first vertex") {
  const Setup setup(
      test::make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}}, {{0, 1, 2}, {4, 5, 3}}),
      {at(0, 0)});
  DualDefect defect = make_defect(DualProperty::component_reached);
  defect.component = 1;
  const Points points = setup.repair(defect);
  REQUIRE(points.size() == 1);
  CHECK(vertex(setup.mesh, points[0]) == VertexId(4));
}

TEST_CASE("a cell round a ring gets two points that cut the shortest loop in thirds with the generator") {
  Setup ring(test::make_ring(3, 1));
  const SurfacePoint generator = vertex_point(ring.mesh, VertexId(0));
  ring.diagram = compute_diagram(ring.mesh, {generator});
  const Points points = ring.repair(make_defect(DualProperty::cell_is_disc, {kA}));
  REQUIRE(points.size() == 2);
  const std::array<Vec3, 3> thirds{position(ring.mesh, generator), position(ring.mesh, points[0]),
                                   position(ring.mesh, points[1])};
  // The loop is the triangle of the generator's rim.
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK((thirds[i] - thirds[(i + 1) % 3]).norm() == Approx(std::sqrt(3.0)));
    CHECK(thirds[i].z() == thirds[0].z());
  }
}

TEST_CASE("a cell that has no loop after all gets its farthest vertex") {
  Setup setup(make_face());
  setup.diagram = compute_diagram(setup.mesh, {at(1, 2)});
  CHECK(setup.repair(make_defect(DualProperty::cell_is_disc, {kA})) == Points{vertex_point(setup.mesh, VertexId(1))});
}

TEST_CASE("of a cell's boundary arcs, the farther one gets its point that is nearest to the generator") {
  Setup ring(test::make_ring(3, 1));
  HalfedgeId up;  // from one rim to the other, along the axis
  for (std::int32_t i = 0; i < ring.mesh.halfedge_count() && !up.valid(); ++i) {
    const HalfedgeId h(i);
    const Vec3 along = ring.mesh.position(ring.mesh.to(h)) - ring.mesh.position(ring.mesh.from(h));
    if (along.z() > 0 && std::hypot(along.x(), along.y()) < 1e-12) up = h;
  }
  REQUIRE(up.valid());
  for (const double height : {0.25, 0.75}) {
    ring.diagram = compute_diagram(ring.mesh, {edge_point(up, height)});
    const Points points = ring.repair(make_defect(DualProperty::one_boundary_arc, {kA}));
    REQUIRE(points.size() == 1);
    const VertexId farther = height < 0.5 ? ring.mesh.to(up) : ring.mesh.from(up);
    CHECK((position(ring.mesh, points[0]) - ring.mesh.position(farther)).norm() < 1e-12);
  }
}

TEST_CASE("a bisector without a branch point gets its farthest point if it is closed, or else its farther end") {
  Setup setup(make_face(), {at(1, 1), at(3, 1)});
  const Points points{at(2, 2), at(2, 5), at(2, 3)};
  const BisectorId closed = setup.add_bisector(kA, kB, points, true), open = setup.add_bisector(kA, kB, points);
  CHECK(setup.repair_bisector(closed) == Points{at(2, 5)});
  CHECK(setup.repair_bisector(open) == Points{at(2, 3)});
  const BisectorId reversed = setup.add_bisector(kA, kB, {points[2], points[1], points[0]});
  CHECK(setup.repair_bisector(reversed) == Points{at(2, 3)});
  // The sum counts: (4.5, 1) is farther from one of the two than (2, 3.5), and nearer to both together.
  const BisectorId sum = setup.add_bisector(kA, kB, {at(2, 3.5), at(4.5, 1)});
  CHECK(setup.repair_bisector(sum) == Points{at(2, 3.5)});
}

TEST_CASE("of two bisectors of a pair, the shortest one relative to its distance gets its midpoint") {
  Setup setup(make_face(), {at(1, 1), at(3, 1), at(1, 6)});
  setup.add_bisector(kA, kB, {at(2, 0), at(2, 0.5), at(2, 1)});
  setup.add_bisector(kB, kA, {at(2, 4), at(2, 4.5), at(2, 5)});                 // as long, and farther away
  setup.add_bisector(kA, kB, {at(2, 2), at(2, 5), at(2, 6)});                   // far away, too, and longer
  setup.add_bisector(kA, kC, {at(0.5, 7), at(0.5, 7.03125), at(0.5, 7.0625)});  // of another pair
  CHECK(setup.repair(make_defect(DualProperty::one_bisector, {kA, kB})) == Points{at(2, 4.5)});
}

TEST_CASE("where a bisector's midpoint is a generator, the farthest of its points is taken") {
  Setup setup(make_face(), {at(1, 1), at(3, 1), at(2, 3)});
  setup.add_bisector(kA, kB, {at(2, 2), at(2, 3), at(2, 4)});
  CHECK(setup.repair(make_defect(DualProperty::one_bisector, {kA, kB})) == Points{at(2, 4)});
}

TEST_CASE("of the branch points of the same three cells, the one that is farthest from them is taken") {
  Setup setup(make_face(), {at(1, 1), at(3, 1), at(1, 3)});
  const BranchPointId near = setup.add_branch(at(2, 2), {kA, kB, kC});
  setup.add_branch(at(3, 4), {kC, kB, kA});
  setup.add_branch(at(1, 6.5), {kA, kB, GeneratorId(3)});  // of other cells
  for (const BranchPointId b : {near, BranchPointId(1)}) {
    CHECK(setup.repair_branch(DualProperty::one_branch_point, b) == Points{at(3, 4)});
  }
}

TEST_CASE("a cell with too few neighbours gets its farthest vertex") {
  Setup setup(test::make_grid(1, 1));
  setup.diagram.generators = {vertex_point(setup.mesh, VertexId(0)), vertex_point(setup.mesh, VertexId(3))};
  setup.label_vertex(0, kA, 0);
  setup.label_vertex(1, kA, 1);
  setup.label_vertex(2, kA, 1.25);
  setup.label_vertex(3, kB, 2);
  const Points points = setup.repair(make_defect(DualProperty::enough_neighbours, {kA}));
  REQUIRE(points.size() == 1);
  CHECK(vertex(setup.mesh, points[0]) == VertexId(2));
}

TEST_CASE("a cell with too few neighbours and no vertex but its generator gets the farthest point of its bisectors") {
  Setup setup(make_face(), {at(0, 0), at(3, 1), at(1, 6)});
  setup.label_vertex(0, kA, 0);
  setup.label_vertex(1, kB, 5);
  const DualDefect defect = make_defect(DualProperty::enough_neighbours, {kA});
  CHECK(setup.repair(defect).empty());
  setup.add_bisector(kA, kB, {at(1, 1), at(2, 3)});
  setup.add_bisector(kC, kA, {at(1, 2), at(1, 4)});
  setup.add_bisector(kB, kC, {at(3, 4), at(1, 7)});  // of other cells
  CHECK(setup.repair(defect) == Points{at(1, 4)});
}

TEST_CASE("a polygon gets the point of its branch point and bisectors that is farthest from all generators") {
  Setup setup(make_face(), {at(1, 1), at(3, 1), at(1, 3), at(0.5, 7)});
  const BranchPointId branch = setup.add_branch(at(2, 2), {kA, kB, kC});
  const BranchPointId alone = setup.add_branch(at(3, 2.5), {kA, kB, GeneratorId(3)});
  setup.add_bisector(kC, kB, {at(2, 2), at(4, 3.5)});
  setup.add_bisector(kA, kC, {at(2, 2), at(0.5, 6.5)});            // its end is next to the fourth generator
  setup.add_bisector(GeneratorId(3), kC, {at(0, 4), at(2.5, 5)});  // not between cells of the first branch point
  for (const DualProperty property :
       {DualProperty::different_cells, DualProperty::polygon_fits, DualProperty::not_flipped}) {
    CHECK(setup.repair_branch(property, branch) == Points{at(4, 3.5)});
    CHECK(setup.repair_branch(property, alone) == Points{at(3, 2.5)});
  }
}

}  // namespace gvd::test_repair_defect
