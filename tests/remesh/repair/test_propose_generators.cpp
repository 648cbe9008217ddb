// Where new generators go: one small diagram for each property that fails.
#include <algorithm>

#include "repair/added_generators.hpp"
#include "repair/propose_generators.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

namespace gvd::test_propose_generators {

struct Case {
  Mesh mesh;
  Diagram diagram;
  std::vector<DualDefect> defects;

  Case(Mesh m, const std::vector<SurfacePoint>& generators) : mesh(std::move(m)) {
    diagram = compute_diagram(mesh, generators);
    defects = check_dual(mesh, diagram);
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

}  // namespace gvd::test_propose_generators
