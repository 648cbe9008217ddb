#include <algorithm>

#include "gvd/error.hpp"
#include "mesh/creases.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_creases {

/// A closed box with sides of length 1, 1 and .5: 12 creases and 8 corners.
Mesh make_box(int n) { return test::make_plate(n, 0.5); }

std::vector<EdgeId> all_boundary(const Mesh& mesh) { return find_creases(mesh, {180, true}); }

TEST_CASE("creases: the edges of a box, none of a sphere, and the boundary on demand") {
  const Mesh box = make_box(4);
  for (const EdgeId e : find_creases(box, {30})) {
    const HalfedgeId h = box.halfedge(e);
    const Vec3 way = (box.position(box.to(h)) - box.position(box.from(h))).cwiseAbs();
    CHECK(way.maxCoeff() == Approx(way.sum()));  // along an axis
  }
  CHECK_FALSE(find_creases(box, {30}).empty());
  CHECK(find_creases(box, {95}).empty());
  CHECK(find_creases(test::make_sphere(3), {30}).empty());
  const Mesh grid = test::make_grid(3, 2);
  CHECK(find_creases(grid, {30}).empty());
  CHECK(all_boundary(grid).size() == 10);
  CHECK_THROWS_AS(find_creases(grid, {0}), Error);
  CHECK_THROWS_AS(find_creases(grid, {181}), Error);
}

TEST_CASE("creases: an edge at the angle itself is none") {
  const Mesh box = make_box(2);
  CHECK(find_creases(box, {90}).empty());
  CHECK(find_creases(box, {89.999}).size() == find_creases(box, {30}).size());
}

TEST_CASE("creases: groups are connected, and long from three spacings on") {
  const Mesh ring = test::make_ring(40, 3);
  const std::vector<EdgeId> boundary = all_boundary(ring);
  const std::vector<CreaseGroup> loops = group_creases(ring, boundary);
  REQUIRE(loops.size() == 2);
  CHECK(loops[0].vertices.front() < loops[1].vertices.front());
  for (const CreaseGroup& loop : loops) {
    CHECK(loop.edges.size() == 40);
    CHECK(loop.vertices.size() == 40);
    CHECK(loop.length == Approx(total_length(ring, loop.edges)));
    CHECK(loop.is_long(loop.length / 3.01));
    CHECK_FALSE(loop.is_long(loop.length / 2.99));
  }
  CHECK(keep_long(loops, loops[0].length / 10) == boundary);
  CHECK(keep_long(loops, loops[0].length).empty());
}

TEST_CASE("creases: curves hold each crease edge once, from corner to corner") {
  const Mesh box = make_box(4), ring = test::make_ring(40, 3);
  const auto creases = find_creases(box, {30});
  const auto curves = trace_creases(box, creases);
  CHECK(curves.size() == 12);
  std::vector<EdgeId> edges;
  for (const CreaseCurve& curve : curves) {
    CHECK_FALSE(curve.closed);
    REQUIRE(curve.vertices.size() == curve.edges.size() + 1);
    for (std::size_t k = 0; k < curve.edges.size(); ++k) {
      CHECK(point_on_edge(box, curve.edges[k], curve.vertices[k], -1) == vertex_point(box, curve.vertices[k]));
      const double length = box.length(box.halfedge(curve.edges[k]));
      const Vec3 middle = position(box, point_on_edge(box, curve.edges[k], curve.vertices[k], length / 4));
      CHECK((middle - box.position(curve.vertices[k])).norm() == Approx(length / 4));
    }
    edges.insert(edges.end(), curve.edges.begin(), curve.edges.end());
  }
  std::sort(edges.begin(), edges.end());
  CHECK(edges == creases);
  const auto loops = trace_creases(ring, all_boundary(ring));
  REQUIRE(loops.size() == 2);
  for (const CreaseCurve& loop : loops) {
    CHECK(loop.closed);
    CHECK(loop.vertices.front() == loop.vertices.back());
  }
}

TEST_CASE("creases: points of a curve lie at their lengths from its first vertex") {
  const Mesh box = make_box(4);
  for (const CreaseCurve& curve : trace_creases(box, find_creases(box, {30}))) {
    const double length = total_length(box, curve.edges);
    const Vec3 from = box.position(curve.vertices.front());
    const std::vector<double> at{0, 0.1 * length, 0.15 * length, 0.8 * length, length};
    const std::vector<SurfacePoint> points = points_on_curve(box, curve, at);
    REQUIRE(points.size() == at.size());
    for (std::size_t i = 0; i < at.size(); ++i) {
      CHECK((position(box, points[i]) - from).norm() ==
            Approx(at[i]).margin(1e-15));  // the sides of a box are straight
    }
    CHECK(points.back() == vertex_point(box, curve.vertices.back()));
  }
}

}  // namespace gvd::test_creases
