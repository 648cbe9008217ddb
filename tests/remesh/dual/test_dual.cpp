// The defects that check_dual finds and the triangles that build_dual makes, on small diagrams whose dual is known;
// faces against the normals of the surface, on one flat square.
#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "gvd/check.hpp"
#include "gvd/dual.hpp"
#include "remesh/dual_defects.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_dual {

bool finds(const std::vector<DualDefect>& defects, DualProperty property) {
  return std::any_of(defects.begin(), defects.end(), [&](const DualDefect& d) { return d.property == property; });
}

/// The vertex that lies farthest along a direction.
SurfacePoint extreme(const Mesh& mesh, const Vec3& direction) {
  VertexId best(0);
  for (std::int32_t v = 1; v < mesh.vertex_count(); ++v) {
    if (mesh.position(VertexId(v)).dot(direction) > mesh.position(best).dot(direction)) best = VertexId(v);
  }
  return vertex_point(mesh, best);
}

std::vector<DualDefect> check(const Mesh& mesh, const std::vector<SurfacePoint>& generators) {
  return test::find_dual_defects(mesh, compute_diagram(mesh, generators));
}

/// The corners of a tetrahedron, as directions.
std::vector<Vec3> tetrahedron() { return {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}; }

std::vector<SurfacePoint> extremes(const Mesh& mesh, const std::vector<Vec3>& directions) {
  std::vector<SurfacePoint> points;
  for (const Vec3& d : directions) points.push_back(extreme(mesh, d));
  return points;
}

/// Shrinks the first bisector between two branch points to a point: they become one, with the cells of both.
Diagram contract_bisector(Diagram diagram) {
  const auto found = std::find_if(diagram.bisectors.begin(), diagram.bisectors.end(),
                                  [](const Bisector& b) { return b.ends[0].valid() && b.ends[1].valid(); });
  const Bisector gone = *found;
  diagram.bisectors.raw().erase(found);
  const auto [kept, lost] = gone.ends;
  std::vector<GeneratorId> first = diagram.branch_points[kept].generators;
  std::vector<GeneratorId> second = diagram.branch_points[lost].generators;
  // Counter-clockwise round `kept` the right cell comes before the left one; round `lost` it is the other way about.
  std::rotate(first.begin(), std::find(first.begin(), first.end(), gone.left), first.end());
  std::rotate(second.begin(), std::find(second.begin(), second.end(), gone.right), second.end());
  first.insert(first.end(), second.begin() + 1, second.end() - 1);
  diagram.branch_points[kept].generators = first;
  diagram.branch_points.raw().erase(diagram.branch_points.begin() + lost.value());
  for (Bisector& b : diagram.bisectors) {
    for (BranchPointId& end : b.ends) {
      if (end == lost) end = kept;
      if (end > lost) end = BranchPointId(end.value() - 1);
    }
  }
  for (Cell& c : diagram.cells) {
    if (c.generator == gone.left) std::erase(c.neighbours, gone.right);
    if (c.generator == gone.right) std::erase(c.neighbours, gone.left);
  }
  return diagram;
}

TEST_CASE("dual: four generators on a sphere make a tetrahedron") {
  const Mesh mesh = test::make_sphere(3);
  const Diagram diagram = compute_diagram(mesh, extremes(mesh, tetrahedron()));
  CHECK(test::find_dual_defects(mesh, diagram).empty());
  const DualMesh dual = build_dual(mesh, diagram);
  REQUIRE(dual.faces.size() == 4);
  CHECK(dual.branch_points.size() == 4);
}

TEST_CASE("dual: (1) a component without a generator is named") {
  const Mesh mesh = test::make_two_components();
  const auto defects = check(mesh, {vertex_point(mesh, VertexId(0))});
  REQUIRE(!defects.empty());
  CHECK(defects.front().property == DualProperty::component_reached);
  CHECK(defects.front().component == 1);
  CHECK(defects.front().message.substr(0, 3) == "(1)");
}

TEST_CASE("dual: (2) a single cell on a sphere, and rings round a cylinder, are no discs") {
  const Mesh sphere = test::make_sphere(2);
  CHECK(finds(check(sphere, {vertex_point(sphere, VertexId(0))}), DualProperty::cell_is_disc));
  const Mesh torus = test::make_torus(24, 12);
  const auto defects = check(torus, extremes(torus, {{1, 0, 0}, {-1, 0, 0}}));
  CHECK(std::count_if(defects.begin(), defects.end(),
                      [](const DualDefect& d) { return d.property == DualProperty::cell_is_disc; }) == 2);
}

TEST_CASE("dual: (3) sectors of a cylinder touch both of its boundaries") {
  const Mesh mesh = test::make_ring(24, 6);
  std::vector<SurfacePoint> generators;
  for (const int corner : {0, 6, 12, 18}) generators.push_back(vertex_point(mesh, VertexId(7 * corner + 3)));
  const auto defects = check(mesh, generators);
  CHECK(std::count_if(defects.begin(), defects.end(),
                      [](const DualDefect& d) { return d.property == DualProperty::one_boundary_arc; }) == 4);
  CHECK(finds(defects, DualProperty::bisector_has_face));
}

TEST_CASE("dual: (4) a bisector from boundary to boundary, or a closed one, has no face") {
  const Mesh grid = test::make_grid(12, 9);
  const auto across = check(grid, extremes(grid, {{-1, -0.1, 0}, {1, 0.1, 0}}));
  CHECK(finds(across, DualProperty::bisector_has_face));
  CHECK(finds(across, DualProperty::enough_neighbours));
  const Mesh sphere = test::make_sphere(3);
  const auto closed = check(sphere, extremes(sphere, {{0, 0, 1}, {0, 0, -1}}));
  CHECK(finds(closed, DualProperty::bisector_has_face));
  CHECK(!finds(closed, DualProperty::cell_is_disc));
}

TEST_CASE("dual: (7) a cell that is a whole component needs two neighbours where that has a boundary, else three") {
  const Mesh triangle({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {{VertexId(0), VertexId(1), VertexId(2)}});
  const auto defects = check(triangle, {vertex_point(triangle, VertexId(0))});
  REQUIRE(defects.size() == 1);
  CHECK_THAT(defects.front().message, Catch::Matchers::Contains("has 0 neighbours and needs 2"));
  const Mesh sphere = test::make_sphere(2);
  const auto closed = check(sphere, {vertex_point(sphere, VertexId(0))});
  CHECK_THAT(closed.back().message, Catch::Matchers::Contains("has 0 neighbours and needs 3"));
}

TEST_CASE("dual: (6) and (7) three cells on a sphere share two branch points") {
  const Mesh mesh = test::make_sphere(3);
  const auto defects = check(mesh, extremes(mesh, {{1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}}));
  CHECK(finds(defects, DualProperty::one_branch_point));
  CHECK(finds(defects, DualProperty::enough_neighbours));
  CHECK(!finds(defects, DualProperty::one_bisector));
}

TEST_CASE("dual: (5) and (8) what a sound diagram seldom has is found in a forged one") {
  const Mesh mesh = test::make_sphere(3);
  Diagram diagram = compute_diagram(mesh, extremes(mesh, tetrahedron()));
  Diagram doubled = diagram;
  doubled.bisectors.push_back(doubled.bisectors[BisectorId(0)]);
  CHECK(finds(test::find_dual_defects(mesh, doubled), DualProperty::one_bisector));
  diagram.branch_points[BranchPointId(0)].generators[1] = diagram.branch_points[BranchPointId(0)].generators[0];
  CHECK(finds(test::find_dual_defects(mesh, diagram), DualProperty::different_cells));
}

TEST_CASE("dual: a branch point of four cells becomes two triangles, along an edge that is none yet") {
  const Mesh mesh = test::make_sphere(3);
  const auto six = extremes(mesh, {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}});
  const Diagram merged = contract_bisector(compute_diagram(mesh, six));
  REQUIRE(merged.branch_points[BranchPointId(0)].generators.size() +
              merged.branch_points[BranchPointId(1)].generators.size() >=
          6);
  CHECK(test::find_dual_defects(mesh, merged).empty());
  const DualMesh dual = build_dual(mesh, merged);
  CHECK(dual.faces.size() == 8);
  CHECK(std::count(dual.branch_points.begin(), dual.branch_points.end(), dual.branch_points[0]) <= 2);
}

TEST_CASE("dual: (9) a polygon whose diagonals are edges already can't be cut") {
  const Mesh mesh = test::make_sphere(3);
  const Diagram diagram = compute_diagram(mesh, extremes(mesh, tetrahedron()));
  Diagram forged = contract_bisector(diagram);
  // Of the square's diagonals one is the other edge of the tetrahedron; now the contracted one is there as well.
  forged.bisectors.push_back(diagram.bisectors[BisectorId(0)]);
  for (const Bisector& b : diagram.bisectors) forged.bisectors.push_back(b);
  CHECK(finds(test::find_dual_defects(mesh, forged), DualProperty::polygon_fits));
}

TEST_CASE("dual: many generators on smooth meshes have no defect") {
  for (const Mesh& mesh : {test::make_sphere(3), test::make_bumpy_sphere(3, 7)}) {
    CHECK(check(mesh, test::random_generators(mesh, 30, 1)).empty());
  }
}

TEST_CASE("dual: the surface's normal on faces, edges and vertices") {
  const Mesh box = test::make_plate(4, 1.0);
  for (std::int32_t v = 0; v < box.vertex_count(); ++v) {
    const Vec3& p = box.position(VertexId(v));
    const Vec3 n = surface_normal(box, vertex_point(box, VertexId(v)));
    CHECK(n.norm() == Approx(1));
    const Vec3 out = p - Vec3(0.5, 0.5, 0.5);
    CHECK(n.dot(out) > 0);
    // At a corner of the box the three angles are right ones, however the squares are split.
    if (std::abs(out.cwiseAbs().minCoeff() - 0.5) < 1e-12) CHECK((n - out.normalized()).norm() < 1e-12);
  }
  const Mesh grid = test::make_grid(2, 2);
  CHECK((surface_normal(grid, edge_point(HalfedgeId(0), 0.5)) - Vec3(0, 0, 1)).norm() < 1e-15);
  CHECK((surface_normal(grid, make_surface_point(FaceId(0), {0.2, 0.3, 0.5})) - Vec3(0, 0, 1)).norm() < 1e-15);
}

/// The faces that are flipped against the plane, of one triangle for each three positions.
std::vector<FaceId> find_flipped(const std::vector<Vec3>& positions) {
  const Mesh plane = test::make_jittered_grid(1, 1, 0, 1);
  std::vector<std::array<int, 3>> faces;
  for (int i = 0; i + 2 < static_cast<int>(positions.size()); i += 3) faces.push_back({i, i + 1, i + 2});
  // Where the generators lie on a plane makes no difference to its normal.
  const SurfacePoint anywhere = make_surface_point(FaceId(0), {0.25, 0.25, 0.5});
  return find_flipped_faces(plane, test::make_mesh(positions, faces),
                            std::vector<SurfacePoint>(positions.size(), anywhere),
                            std::vector<SurfacePoint>(faces.size(), anywhere));
}

TEST_CASE("faces that turn their back to the surface are flipped, and are listed in order") {
  const Vec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
  CHECK(find_flipped({a, b, c}).empty());
  CHECK(find_flipped({a, c, b}) == std::vector<FaceId>{FaceId(0)});
  CHECK(find_flipped({a, c, b, a, b, c, b, a, c}) == std::vector<FaceId>{FaceId(0), FaceId(2)});
}

TEST_CASE("a face without area, or upright on the surface, counts as flipped up to the tolerance") {
  const Vec3 a(0, 0, 0), b(1, 0, 0);
  CHECK(find_flipped({a, b, {0.5, 0, 0}}).size() == 1);
  CHECK(find_flipped({a, b, {0.5, 0.5 * kFlipTolerance, 0}}).size() == 1);
  CHECK(find_flipped({a, b, {0.5, 2 * kFlipTolerance, 0}}).empty());
  CHECK(find_flipped({a, b, {0.5, 0, 1}}).size() == 1);
  CHECK(find_flipped({a, b, {0.5, 0.5 * kFlipTolerance, 1}}).size() == 1);
  CHECK(find_flipped({a, b, {0.5, 2 * kFlipTolerance, 1}}).empty());
}

TEST_CASE("triangles of a dual are judged without the rest of it") {
  const Mesh sphere = test::make_sphere(2);
  const Diagram diagram = compute_diagram(sphere, test::random_generators(sphere, 30, 0));
  DualMesh dual = build_dual(sphere, diagram);
  CHECK(find_flipped_triangles(sphere, diagram, dual).empty());
  std::swap(dual.faces[2][0], dual.faces[2][1]);
  dual.faces[4] = dual.faces[2];  // no mesh any more: two faces with the same corners, and a hole
  dual.branch_points[4] = dual.branch_points[2];
  CHECK(find_flipped_triangles(sphere, diagram, dual) == std::vector<std::size_t>{2, 4});
}

}  // namespace gvd::test_dual
