#include <algorithm>
#include <set>
#include <vector>

#include "mesh/vertex_ring.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_vertex_ring {

std::vector<HalfedgeId> outgoing(const Mesh& mesh, VertexId v) {
  std::vector<HalfedgeId> result;
  for_each_outgoing(mesh, v, [&](HalfedgeId h) { result.push_back(h); });
  return result;
}

std::vector<HalfedgeId> outgoing_by_scan(const Mesh& mesh, VertexId v) {
  std::vector<HalfedgeId> result;
  for (int i = 0; i < mesh.halfedge_count(); ++i) {
    if (mesh.from(HalfedgeId(i)) == v) result.push_back(HalfedgeId(i));
  }
  return result;
}

TEST_CASE("vertex ring: every outgoing halfedge once, on every family") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    for (int v = 0; v < mesh.vertex_count(); ++v) {
      std::vector<HalfedgeId> found = outgoing(mesh, VertexId(v));
      REQUIRE(found.front() == mesh.halfedge(VertexId(v)));
      std::sort(found.begin(), found.end());
      REQUIRE(found == outgoing_by_scan(mesh, VertexId(v)));
    }
  }
}

TEST_CASE("vertex ring: the steps counter-clockwise and clockwise undo each other and end at the boundary") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    for (int i = 0; i < mesh.halfedge_count(); ++i) {
      const HalfedgeId h(i), next = next_outgoing(mesh, h), previous = previous_outgoing(mesh, h);
      if (next.valid()) {
        REQUIRE(mesh.from(next) == mesh.from(h));
        REQUIRE(previous_outgoing(mesh, next) == h);
        REQUIRE(mesh.opposite(h) == mesh.to(next));
      } else {
        REQUIRE(mesh.is_boundary(mesh.edge(Mesh::previous(h))));
      }
      REQUIRE(previous.valid() == mesh.twin(h).valid());
      if (previous.valid()) REQUIRE(next_outgoing(mesh, previous) == h);
    }
  }
}

TEST_CASE("vertex ring: each neighbour once, with a halfedge of the edge between") {
  for (const auto& member : test::small_family()) {
    INFO(member.name);
    const Mesh& mesh = member.mesh;
    for (int i = 0; i < mesh.vertex_count(); ++i) {
      const VertexId v(i);
      std::set<VertexId> expected, found;
      for (int e = 0; e < mesh.edge_count(); ++e) {
        const HalfedgeId h = mesh.halfedge(EdgeId(e));
        if (mesh.from(h) == v) expected.insert(mesh.to(h));
        if (mesh.to(h) == v) expected.insert(mesh.from(h));
      }
      for_each_neighbour(mesh, v, [&](VertexId u, HalfedgeId h) {
        REQUIRE(found.insert(u).second);
        REQUIRE(((mesh.from(h) == v && mesh.to(h) == u) || (mesh.from(h) == u && mesh.to(h) == v)));
      });
      REQUIRE(found == expected);
      for (const VertexId u : expected) REQUIRE(any_neighbour(mesh, v, [&](VertexId w) { return w == u; }));
      REQUIRE_FALSE(any_neighbour(mesh, v, [&](VertexId w) { return w == v; }));
    }
  }
}

TEST_CASE("vertex ring: any_neighbour stops at the first one") {
  const Mesh mesh = test::make_tetrahedron();
  int asked = 0;
  CHECK(any_neighbour(mesh, VertexId(0), [&](VertexId) { return ++asked == 2; }));
  CHECK(asked == 2);
}

TEST_CASE("vertex ring: next_on_boundary goes once along each boundary loop") {
  const Mesh ring = test::make_ring(12, 3);
  for (int i = 0; i < ring.halfedge_count(); ++i) {
    const HalfedgeId start(i);
    if (ring.twin(start).valid()) continue;
    int length = 0;
    HalfedgeId h = start;
    do {
      REQUIRE_FALSE(ring.twin(h).valid());
      REQUIRE(ring.from(next_on_boundary(ring, h)) == ring.to(h));
      h = next_on_boundary(ring, h);
      REQUIRE(++length <= 12);
    } while (h != start);
    REQUIRE(length == 12);
  }
}

TEST_CASE("vertex ring: a single triangle, and a pillow of two") {
  const Mesh triangle = test::make_triangle(), pillow = test::make_pillow();
  for (int v = 0; v < 3; ++v) {
    CHECK(outgoing(triangle, VertexId(v)).size() == 1);
    CHECK(outgoing(pillow, VertexId(v)).size() == 2);
    std::vector<VertexId> neighbours;
    for_each_neighbour(triangle, VertexId(v), [&](VertexId u, HalfedgeId) { neighbours.push_back(u); });
    CHECK(neighbours.size() == 2);
  }
}

}  // namespace gvd::test_vertex_ring
