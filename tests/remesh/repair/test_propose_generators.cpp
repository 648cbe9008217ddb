// Where new generators go: lengths of bisectors, the row of the table for each property on the smallest mesh and with
// diagrams made by hand, small diagrams for each property that fails, and repairs on a part of the mesh.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "diagram/bisector_length.hpp"
#include "gvd/dual.hpp"
#include "remesh/dual_defects.hpp"
#include "repair/added_generators.hpp"
#include "repair/propose_generators.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_propose_generators {

/// A bisector along the bottom of a grid, through the points with these x.
Bisector make_bisector(const std::vector<double>& xs) {
  Bisector b;
  for (const double x : xs) {
    const int square = std::min(static_cast<int>(x), 3);
    b.points.push_back(edge_point(Mesh::halfedge(FaceId(2 * square), 0), x - square));
  }
  return b;
}

TEST_CASE("bisector length: of a single point it is 0, and the point is the middle") {
  const Mesh mesh = test::make_grid(4, 1);
  const Bisector b = make_bisector({1.5});
  CHECK(compute_length(mesh, b) == 0);
  CHECK(find_midpoint(mesh, b) == b.points[0]);
}

TEST_CASE("bisector length: coincident points have length 0") {
  const Mesh mesh = test::make_grid(4, 1);
  const Bisector b = make_bisector({1.5, 1.5, 1.5});
  CHECK(compute_length(mesh, b) == 0);
  CHECK(position(mesh, find_midpoint(mesh, b)) == Vec3(1.5, 0, 0));
}

TEST_CASE("bisector length: the midpoint is the point nearest to half of the length") {
  const Mesh mesh = test::make_grid(4, 1);
  const auto middle = [&](const std::vector<double>& xs) {
    return position(mesh, find_midpoint(mesh, make_bisector(xs))).x();
  };
  CHECK(compute_length(mesh, make_bisector({0.5, 1, 3.5})) == Approx(3));
  CHECK(middle({0, 1, 2, 3, 4}) == 2);
  CHECK(middle({0, 0.25, 0.5, 4}) == Approx(0.5));
  CHECK(middle({0, 3.5, 4}) == Approx(3.5));
  CHECK(middle({0, 4}) == 4);  // of two equally near, the later one
}

TEST_CASE("bisector length: a closed one has the segment back to its first point, and its middle is opposite") {
  const Mesh mesh = test::make_grid(4, 1);
  Bisector b = make_bisector({0, 1, 2});
  b.closed = true;
  CHECK(compute_length(mesh, b) == Approx(4));
  CHECK(position(mesh, find_midpoint(mesh, b)).x() == Approx(2));
}

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
    Diagram with_cells = diagram;
    with_cells.cells.resize(diagram.generators.size());
    return propose_generators(mesh, with_cells, {defect}, 100).points;
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
  Setup setup(make_face(), {at(1, 1), at(3, 1), at(1, 3), at(0.5, 7)});
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

struct Case {
  Mesh mesh;
  Diagram diagram;
  std::vector<DualDefect> defects;

  Case(Mesh m, const std::vector<SurfacePoint>& generators) : mesh(std::move(m)) {
    diagram = compute_diagram(mesh, generators);
    defects = test::find_dual_defects(mesh, diagram);
  }
  /// Only the defects of one property.
  std::vector<SurfacePoint> propose(DualProperty property, std::size_t max_count = 100) const {
    std::vector<DualDefect> some;
    std::copy_if(defects.begin(), defects.end(), std::back_inserter(some),
                 [&](const DualDefect& d) { return d.property == property; });
    REQUIRE(!some.empty());
    return propose_generators(mesh, diagram, some, max_count).points;
  }
};

std::vector<SurfacePoint> vertices(const Mesh& mesh, const std::vector<int>& ids) {
  std::vector<SurfacePoint> points;
  for (const int v : ids) points.push_back(vertex_point(mesh, VertexId(v)));
  return points;
}

TEST_CASE("proposed generators: none without defects") {
  const Mesh mesh = test::make_sphere(2);
  const Diagram diagram = compute_diagram(mesh, vertices(mesh, {0, 3, 8}));
  CHECK(propose_generators(mesh, diagram, {}, 10).points.empty());
}

TEST_CASE("proposed generators: a component without a generator gets its first vertex") {
  const Mesh mesh = test::make_two_components();
  const Case c(mesh, vertices(mesh, {0}));
  const auto points = c.propose(DualProperty::component_reached);
  REQUIRE(points.size() == 1);
  CHECK(compute_face_components(mesh)[points[0].face] == 1);
  CHECK(points[0].kind() == SurfacePoint::Kind::vertex);
}

TEST_CASE("proposed generators: a cell round a cylinder is divided in thirds, and no more than allowed") {
  const Mesh ring = test::make_ring(24, 6);
  const Case c(ring, vertices(ring, {3}));
  CHECK(c.propose(DualProperty::cell_is_disc).size() == 2);
  CHECK(c.propose(DualProperty::cell_is_disc, 1).size() == 1);
}

TEST_CASE("proposed generators: a cell with two boundary arcs gets one on the farther arc") {
  const Mesh ring = test::make_ring(24, 6);
  std::vector<int> ids;
  for (const int column : {0, 6, 12, 18}) ids.push_back(7 * column + 1);  // nearer to the arc at z = 0
  const Case c(ring, vertices(ring, ids));
  const auto points = c.propose(DualProperty::one_boundary_arc);
  REQUIRE(!points.empty());
  for (const SurfacePoint& p : points) CHECK(position(ring, p).z() == Approx(0.5));
}

TEST_CASE("proposed generators: a closed bisector gets one of its points, an open one an end on the boundary") {
  const Mesh sphere = test::make_sphere(3);
  const Case closed(sphere, vertices(sphere, {0, 3}));
  const auto on_closed = closed.propose(DualProperty::bisector_has_face);
  REQUIRE(on_closed.size() == 1);
  const auto& points = closed.diagram.bisectors[BisectorId(0)].points;
  CHECK(std::find(points.begin(), points.end(), on_closed[0]) != points.end());
  const Mesh grid = test::make_grid(6, 2);
  const Case open(grid, vertices(grid, {7, 13}));
  const auto on_open = open.propose(DualProperty::bisector_has_face);
  REQUIRE(on_open.size() == 1);
  CHECK(is_on_boundary(grid, on_open[0]));
  CHECK(position(grid, on_open[0]).x() == Approx(3));
}

TEST_CASE("proposed generators: a cell with too few neighbours gets its farthest vertex") {
  const Mesh sphere = test::make_sphere(3);
  const Case c(sphere, vertices(sphere, {0}));
  const auto points = c.propose(DualProperty::enough_neighbours);
  REQUIRE(points.size() == 1);
  REQUIRE(points[0].kind() == SurfacePoint::Kind::vertex);
  const auto& distance = c.diagram.vertex_distance;
  CHECK(distance[vertex(sphere, points[0])] == *std::max_element(distance.begin(), distance.end()));
}

TEST_CASE("proposed generators: three cells with two common branch points get one of them") {
  const Mesh sphere = test::make_sphere(3);
  const Case c(sphere, test::random_generators(sphere, 3, 5));
  const auto points = c.propose(DualProperty::one_branch_point);
  REQUIRE(points.size() == 1);
  const auto& branches = c.diagram.branch_points;
  CHECK(std::any_of(branches.begin(), branches.end(), [&](const BranchPoint& b) { return b.point == points[0]; }));
}

TEST_CASE("proposed generators: a cell takes part in one repair only") {
  const Mesh sphere = test::make_sphere(3);
  const Case c(sphere, vertices(sphere, {0, 3}));
  REQUIRE(c.defects.size() > 1);
  CHECK(propose_generators(c.mesh, c.diagram, c.defects, 100).points.size() == 1);
}

TEST_CASE("proposed generators: on every family each one is clear of the others of its component") {
  for (const auto& [name, mesh] : test::small_family()) {
    for (const int count : {1, 2, 4}) {
      CAPTURE(name, count);
      const Case c(mesh, test::random_generators(mesh, count, 1));
      if (c.defects.empty()) continue;
      const auto points = propose_generators(mesh, c.diagram, c.defects, 100).points;
      CHECK(!points.empty());
      std::vector<SurfacePoint> all = c.diagram.generators;
      for (const SurfacePoint& p : points) {
        CHECK(AddedGenerators(mesh, all, 1).clearance(p) > kMinAddedSpacing * mesh.bbox_diagonal());
        all.push_back(p);
      }
    }
  }
}

/// A closed surface with many defects at 80 generators, in many places: a torus whose tube is thin.
Mesh make_thin_torus() {
  const Mesh torus = test::make_torus(240, 12);
  std::vector<Vec3> positions;
  std::vector<std::array<VertexId, 3>> faces;
  for (const Vec3& p : torus.positions()) {
    const Vec3 on_circle = Vec3(p.x(), p.y(), 0).normalized();
    positions.push_back(on_circle + 0.15 * (p - on_circle));
  }
  for (std::int32_t f = 0; f < torus.face_count(); ++f) faces.push_back(torus.vertices(FaceId(f)));
  return Mesh(std::move(positions), std::move(faces));
}

std::vector<SurfacePoint> joined(std::vector<SurfacePoint> first, const std::vector<SurfacePoint>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

std::size_t count_defects(const Mesh& mesh, const std::vector<SurfacePoint>& generators) {
  return test::find_dual_defects(mesh, compute_diagram(mesh, generators)).size();
}

TEST_CASE("generators nearby: with them fewer defects are left, within the number allowed") {
  const Mesh mesh = make_thin_torus();
  int repaired = 0;
  for (unsigned seed = 0; seed < 6; ++seed) {
    INFO("seed " << seed);
    const auto generators = test::random_generators(mesh, 60, seed);
    const Diagram diagram = compute_diagram(mesh, generators);
    const auto defects = test::find_dual_defects(mesh, diagram);
    REQUIRE(!defects.empty());
    const auto points = propose_generators(mesh, diagram, {defects.front()}, 10).points;
    const auto nearby = propose_nearby(mesh, diagram, points, 20, {}).points;
    CHECK(nearby.size() <= 20);
    CHECK(propose_nearby(mesh, diagram, points, 1, {}).points.size() <= 1);
    CHECK(propose_nearby(mesh, diagram, points, 20, {}).points == nearby);
    if (nearby.empty()) continue;
    ++repaired;
    const auto with_points = joined(generators, points);
    CHECK(count_defects(mesh, joined(with_points, nearby)) < count_defects(mesh, with_points));
  }
  CHECK(repaired > 0);
}

TEST_CASE("generators nearby: none where the part would be more than a quarter of the mesh") {
  const Mesh mesh = make_thin_torus();
  const auto generators = test::random_generators(mesh, 4, 1);
  const Diagram diagram = compute_diagram(mesh, generators);
  const auto defects = test::find_dual_defects(mesh, diagram);
  REQUIRE(!defects.empty());
  const auto points = propose_generators(mesh, diagram, {defects.front()}, 10).points;
  CHECK(propose_nearby(mesh, diagram, points, 20, {}).points.empty());
}

}  // namespace gvd::test_propose_generators
