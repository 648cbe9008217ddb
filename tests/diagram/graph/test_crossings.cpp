// Crossings on edges, and how faces see them.
#include <utility>
#include <vector>

#include "diagram/graph/crossings.hpp"
#include "support/catch.hpp"
#include "support/edge_between.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/stages.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_crossings {

const GeneratorId kA(0), kB(1), kC(2);

Crossing on(int edge, double t, GeneratorId before, GeneratorId after) { return {EdgeId(edge), t, before, after}; }

std::vector<std::pair<int, double>> places(const Crossings& crossings) {
  std::vector<std::pair<int, double>> result;
  for (const Crossing& c : crossings.items()) result.emplace_back(c.edge.value(), c.t);
  return result;
}

using Places = std::vector<std::pair<int, double>>;

TEST_CASE("no crossings: no edge has any, and no face is crossed") {
  const Mesh mesh = test::make_triangle();
  const Crossings none(mesh.edge_count(), {});
  CHECK(none.size() == 0);
  for (int e = 0; e < 3; ++e) {
    CHECK_FALSE(none.first(EdgeId(e)).valid());
    CHECK(none.count(EdgeId(e)) == 0);
  }
  CHECK(boundary_crossings(mesh, none, FaceId(0)).empty());
  CHECK(crossed_faces(mesh, none).empty());
}

TEST_CASE("an edge knows its first crossing and their number") {
  const Crossings crossings(4, {on(0, 0.2, kA, kB), on(0, 0.7, kB, kA), on(3, 0.5, kA, kC)});
  CHECK(crossings.first(EdgeId(0)) == CrossingId(0));
  CHECK(crossings.count(EdgeId(0)) == 2);
  CHECK_FALSE(crossings.first(EdgeId(1)).valid());
  CHECK(crossings.count(EdgeId(1)) == 0);
  CHECK(crossings.first(EdgeId(3)) == CrossingId(2));
  CHECK(crossings.count(EdgeId(3)) == 1);
  CHECK(crossings[CrossingId(2)].after == kC);
}

TEST_CASE("replacing the crossings of some edges leaves the others, and the order") {
  const Crossings before(5, {on(0, 0.2, kA, kB), on(0, 0.7, kB, kA), on(2, 0.5, kA, kC), on(4, 0.1, kA, kB)});
  SECTION("of no edge") {
    Crossings after = before;
    after.replace({}, {});
    CHECK(places(after) == places(before));
  }
  SECTION("by none") {
    Crossings after = before;
    after.replace({EdgeId(0), EdgeId(4)}, {});
    CHECK(places(after) == Places{{2, 0.5}});
    CHECK(after.first(EdgeId(2)) == CrossingId(0));
    CHECK(after.count(EdgeId(0)) == 0);
  }
  SECTION("of edges with and without crossings, by more than there were") {
    Crossings after = before;
    after.replace({EdgeId(0), EdgeId(1), EdgeId(3)},
                  {on(0, 0.4, kA, kB), on(1, 0.3, kB, kC), on(1, 0.6, kC, kB), on(3, 0.9, kA, kB)});
    CHECK(places(after) == Places{{0, 0.4}, {1, 0.3}, {1, 0.6}, {2, 0.5}, {3, 0.9}, {4, 0.1}});
    CHECK(after.count(EdgeId(1)) == 2);
    CHECK(after.first(EdgeId(4)) == CrossingId(5));
  }
  SECTION("of all edges of an empty list") {
    Crossings after(2, {});
    after.replace({EdgeId(0), EdgeId(1)}, {on(1, 0.5, kA, kB)});
    CHECK(places(after) == Places{{1, 0.5}});
  }
}

TEST_CASE("a boundary crossing lies on its halfedge") {
  for (int corner = 0; corner < 3; ++corner) {
    const auto bary = BoundaryCrossing{CrossingId(0), corner, 0.25, kA, kB}.bary();
    const auto i = static_cast<std::size_t>(corner);
    CHECK(bary[i] == 0.75);
    CHECK(bary[(i + 1) % 3] == 0.25);
    CHECK(bary[(i + 2) % 3] == 0);
  }
}

TEST_CASE("the two faces of an edge see its crossings in opposite orders, with their cells exchanged") {
  const Mesh mesh = test::make_grid(1, 1);
  const EdgeId e = test::edge_between(mesh, 0, 3);
  const Crossings crossings(mesh.edge_count(), {{e, 0.2, kA, kB}, {e, 0.6, kB, kC}});
  const HalfedgeId h = mesh.halfedge(e), twin = mesh.twin(h);
  const auto own = boundary_crossings(mesh, crossings, Mesh::face(h));
  const auto other = boundary_crossings(mesh, crossings, Mesh::face(twin));
  REQUIRE((own.size() == 2 && other.size() == 2));
  for (std::size_t i = 0; i < 2; ++i) {
    const BoundaryCrossing &a = own[i], &b = other[1 - i];
    CHECK(a.id == b.id);
    CHECK(a.corner == Mesh::corner(h));
    CHECK(b.corner == Mesh::corner(twin));
    CHECK(a.t == Approx(1 - b.t).epsilon(1e-15));
    CHECK((a.previous == b.next && a.next == b.previous));
  }
  CHECK(own[0].previous == kA);
  CHECK(other[0].previous == kC);
}

TEST_CASE("an edge counts for each of its faces: two inside, one on the boundary") {
  const Mesh mesh = test::make_grid(1, 1);
  const EdgeId inner = test::edge_between(mesh, 0, 3), outer = test::edge_between(mesh, 0, 1);
  Crossings crossings(mesh.edge_count(), {{outer, 0.5, kA, kB}});
  CHECK(crossed_faces(mesh, crossings) == std::vector<FaceId>{Mesh::face(mesh.halfedge(outer))});
  crossings.replace({inner}, {{inner, 0.2, kA, kB}, {inner, 0.4, kB, kA}});
  const auto counts = count_by_face(mesh, crossings);
  CHECK(counts[Mesh::face(mesh.halfedge(outer))] == 3);
  CHECK(counts[FaceId(0)] + counts[FaceId(1)] == 5);
  CHECK(crossed_faces(counts) == std::vector<FaceId>{FaceId(0), FaceId(1)});
}

TEST_CASE("a face sees its crossings counter-clockwise, and the cells between them agree with its corners") {
  const Mesh mesh = test::make_bumpy_sphere(3, 7);
  const test::Stages stages(mesh, test::random_generators(mesh, 100, 4), Front::circle);
  std::vector<char> seen(static_cast<std::size_t>(stages.mesh().face_count()), 0);
  for (const FaceId f : crossed_faces(stages.mesh(), stages.rough)) {
    seen[f.index()] = 1;
    const auto boundary = boundary_crossings(stages.mesh(), stages.rough, f);
    REQUIRE(boundary.size() >= 2);
    for (std::size_t i = 0; i < boundary.size(); ++i) {
      const BoundaryCrossing &c = boundary[i], &next = boundary[(i + 1) % boundary.size()];
      REQUIRE(c.next == next.previous);
      if (i + 1 < boundary.size()) REQUIRE(std::pair(c.corner, c.t) < std::pair(next.corner, next.t));
    }
    REQUIRE(boundary.front().previous == stages.labels.label[stages.mesh().vertices(f)[0]]);
  }
  for (int f = 0; f < stages.mesh().face_count(); ++f) {
    if (!seen[FaceId(f).index()]) REQUIRE(boundary_crossings(stages.mesh(), stages.rough, FaceId(f)).empty());
  }
}

}  // namespace gvd::test_crossings
