#include <map>

#include "repair/cell_topology.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_boundary_arcs {

double length(const Mesh& mesh, const BoundaryArc& arc) {
  double sum = 0;
  for (const auto& s : arc.segments) sum += (s.end - s.begin) * mesh.length(s.halfedge);
  return sum;
}

double boundary_length(const Mesh& mesh) {
  double sum = 0;
  for (int e = 0; e < mesh.edge_count(); ++e) sum += mesh.is_boundary(EdgeId(e)) ? mesh.length(EdgeId(e)) : 0;
  return sum;
}

TEST_CASE("boundary arcs: a closed surface has none, and neither has a component without a generator") {
  const Mesh sphere = test::make_sphere(1);
  CHECK(list_boundary_arcs(sphere, compute_diagram(sphere, test::random_generators(sphere, 3, 0))).empty());
  const Mesh two =
      test::make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}}, {{0, 1, 2}, {3, 4, 5}});
  const auto arcs = list_boundary_arcs(two, compute_diagram(two, {vertex_point(two, VertexId(0))}));
  REQUIRE(arcs.size() == 1);
  CHECK(arcs[0].segments.size() == 3);
}

TEST_CASE("boundary arcs: without ends of bisectors an arc is a whole loop") {
  const Mesh ring = test::make_ring(12, 3);
  const auto arcs = list_boundary_arcs(ring, compute_diagram(ring, {vertex_point(ring, VertexId(0))}));
  REQUIRE(arcs.size() == 2);
  for (const BoundaryArc& arc : arcs) {
    CHECK(arc.cell == GeneratorId(0));
    CHECK(length(ring, arc) == Approx(boundary_length(ring) / 2));
  }
}

TEST_CASE("boundary arcs: two cells of a rectangle have one arc each, up to the ends of their bisector") {
  const Mesh grid = test::make_grid(4, 2);
  const auto generators = {vertex_point(grid, VertexId(5)), vertex_point(grid, VertexId(9))};  // (0, 1) and (4, 1)
  const auto arcs = list_boundary_arcs(grid, compute_diagram(grid, generators));
  REQUIRE(arcs.size() == 2);
  CHECK(arcs[0].cell != arcs[1].cell);
  for (const BoundaryArc& arc : arcs) {
    CHECK(length(grid, arc) == Approx(6));
    const bool left = arc.cell == GeneratorId(0);
    for (const auto& s : arc.segments) {
      for (const double t : {s.begin, s.end}) {
        const double x = position(grid, edge_point(s.halfedge, t)).x();
        CHECK((left ? x <= 2 + 1e-9 : x >= 2 - 1e-9));
      }
    }
  }
}

TEST_CASE("boundary arcs: the nearest point of an arc") {
  const Mesh grid = test::make_grid(4, 2);
  BoundaryArc arc;
  arc.segments = {{Mesh::halfedge(FaceId(0), 0), 0.25, 1}, {Mesh::halfedge(FaceId(2), 0), 0, 0.5}};  // x in [0.25, 1.5]
  const auto nearest = [&](const Vec3& to) { return position(grid, find_nearest_point(grid, arc, to)); };
  CHECK((nearest({0, 0, 0}) - Vec3(0.25, 0, 0)).norm() < 1e-15);
  CHECK((nearest({0.7, 2, 0}) - Vec3(0.7, 0, 0)).norm() < 1e-15);
  CHECK((nearest({1.2, -1, 3}) - Vec3(1.2, 0, 0)).norm() < 1e-15);
  CHECK((nearest({9, 0, 0}) - Vec3(1.5, 0, 0)).norm() < 1e-15);
  CHECK(find_nearest_point(grid, arc, {1, 0, 0}).kind() == SurfacePoint::Kind::vertex);
}

TEST_CASE("boundary arcs: they cover the boundary once, and each cell has as many as its bisectors' ends say") {
  for (const auto& [name, mesh] : test::small_family()) {
    for (const int count : {1, 3, 20}) {
      CAPTURE(name, count);
      const Diagram diagram = compute_diagram(mesh, test::random_generators(mesh, count, 2));
      double sum = 0;
      std::map<GeneratorId, int> arcs_of, ends_of;
      for (const BoundaryArc& arc : list_boundary_arcs(mesh, diagram)) {
        sum += length(mesh, arc);
        ++arcs_of[arc.cell];
        const HalfedgeId first = arc.segments.front().halfedge;
        CHECK_FALSE(mesh.twin(first).valid());
      }
      CHECK(sum == Approx(boundary_length(mesh)).margin(1e-12));
      for (const Bisector& b : diagram.bisectors) {
        for (const BranchPointId end : b.ends) {
          if (b.closed || end.valid()) continue;
          ++ends_of[b.left];
          ++ends_of[b.right];
        }
      }
      for (const auto& [cell, ends] : ends_of) CHECK(2 * arcs_of[cell] >= ends);
    }
  }
}

}  // namespace gvd::test_boundary_arcs
