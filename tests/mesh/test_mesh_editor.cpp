#include <array>
#include <cmath>
#include <set>
#include <vector>

#include "mesh/mesh_editor.hpp"
#include "mesh/vertex_ring.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/random.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_mesh_editor {

using Face = std::array<VertexId, 3>;

Face face(int a, int b, int c) { return {VertexId(a), VertexId(b), VertexId(c)}; }

/// The edited mesh agrees with one that is built from its vertices and faces.
void require_valid(const Mesh& mesh) {
  std::vector<Face> faces;
  for (int f = 0; f < mesh.face_count(); ++f) faces.push_back(mesh.vertices(FaceId(f)));
  const Mesh built(mesh.positions(), faces);
  REQUIRE(mesh.vertex_count() == built.vertex_count());
  REQUIRE(mesh.edge_count() == built.edge_count());
  std::set<EdgeId> edges;
  for (int i = 0; i < mesh.halfedge_count(); ++i) {
    const HalfedgeId h(i);
    REQUIRE(mesh.twin(h) == built.twin(h));
    REQUIRE(mesh.length(h) == built.length(h));
    REQUIRE((mesh.halfedge(mesh.edge(h)) == h || mesh.halfedge(mesh.edge(h)) == mesh.twin(h)));
    if (mesh.twin(h).valid()) REQUIRE(mesh.edge(mesh.twin(h)) == mesh.edge(h));
    edges.insert(mesh.edge(h));
  }
  REQUIRE(edges.size() == static_cast<std::size_t>(mesh.edge_count()));
  for (int f = 0; f < mesh.face_count(); ++f) REQUIRE(mesh.area(FaceId(f)) == built.area(FaceId(f)));
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const HalfedgeId h = mesh.halfedge(VertexId(v));
    REQUIRE(mesh.from(h) == VertexId(v));
    REQUIRE(mesh.is_boundary(VertexId(v)) == built.is_boundary(VertexId(v)));
    if (built.is_boundary(VertexId(v))) REQUIRE(h == built.halfedge(VertexId(v)));
  }
}

double area_of(const Mesh& mesh) { return compute_mesh_summary(mesh).area; }

Vec3 centre(const Mesh& mesh, FaceId f) {
  const auto& [a, b, c] = mesh.vertices(f);
  return (mesh.position(a) + mesh.position(b) + mesh.position(c)) / 3;
}

Vec3 middle(const Mesh& mesh, HalfedgeId h) { return 0.5 * (mesh.position(mesh.from(h)) + mesh.position(mesh.to(h))); }

TEST_CASE("mesh editor: splitting a face gives the faces that are promised, in their order") {
  Mesh mesh = test::make_triangle();
  const VertexId v = MeshEditor(mesh).split_face(FaceId(0), centre(mesh, FaceId(0)));
  CHECK(v == VertexId(3));
  REQUIRE(mesh.face_count() == 3);
  CHECK(mesh.vertices(FaceId(0)) == face(0, 1, 3));
  CHECK(mesh.vertices(FaceId(1)) == face(1, 2, 3));
  CHECK(mesh.vertices(FaceId(2)) == face(2, 0, 3));
  CHECK_FALSE(mesh.is_boundary(v));
  require_valid(mesh);
}

TEST_CASE("mesh editor: splitting a boundary edge, at each corner of a face") {
  for (int corner = 0; corner < 3; ++corner) {
    Mesh mesh = test::make_triangle();
    const HalfedgeId h = Mesh::halfedge(FaceId(0), corner);
    const int a = corner, b = (corner + 1) % 3, c = (corner + 2) % 3;
    const VertexId v = MeshEditor(mesh).split_edge(h, middle(mesh, h));
    REQUIRE(mesh.face_count() == 2);
    CHECK(mesh.vertices(FaceId(0)) == face(a, 3, c));
    CHECK(mesh.vertices(FaceId(1)) == face(3, b, c));
    CHECK(mesh.is_boundary(v));
    require_valid(mesh);
  }
}

TEST_CASE("mesh editor: splitting an inner edge splits both faces") {
  Mesh mesh = test::make_tetrahedron();
  const HalfedgeId h = Mesh::halfedge(FaceId(0), 0);
  const VertexId a = mesh.from(h), b = mesh.to(h), c = mesh.opposite(h), d = mesh.opposite(mesh.twin(h));
  const FaceId other = Mesh::face(mesh.twin(h));
  const VertexId v = MeshEditor(mesh).split_edge(h, middle(mesh, h));
  REQUIRE(mesh.face_count() == 6);
  CHECK(mesh.vertices(FaceId(0)) == Face{a, v, c});
  CHECK(mesh.vertices(FaceId(4)) == Face{v, b, c});
  CHECK(mesh.vertices(other) == Face{b, v, d});
  CHECK(mesh.vertices(FaceId(5)) == Face{v, a, d});
  require_valid(mesh);
}

TEST_CASE("mesh editor: flipping an edge, and back") {
  Mesh mesh = test::make_grid(1, 1);
  const double area = area_of(mesh);
  HalfedgeId diagonal;
  for (int i = 0; i < mesh.halfedge_count(); ++i) {
    if (mesh.twin(HalfedgeId(i)).valid()) diagonal = HalfedgeId(i);
  }
  const VertexId a = mesh.from(diagonal), b = mesh.to(diagonal), c = mesh.opposite(diagonal),
                 d = mesh.opposite(mesh.twin(diagonal));
  const FaceId f = Mesh::face(diagonal), g = Mesh::face(mesh.twin(diagonal));
  MeshEditor(mesh).flip_edge(diagonal);
  CHECK(mesh.vertices(f) == Face{d, b, c});
  CHECK(mesh.vertices(g) == Face{c, a, d});
  require_valid(mesh);
  CHECK(area_of(mesh) == Approx(area));
  MeshEditor(mesh).flip_edge(Mesh::halfedge(f, 2));
  require_valid(mesh);
  const HalfedgeId back = Mesh::halfedge(f, 2);
  CHECK(std::set<VertexId>{mesh.from(back), mesh.to(back)} == std::set<VertexId>{a, b});
}

TEST_CASE("mesh editor: both faces of a pillow can be split") {
  Mesh mesh = test::make_pillow();
  MeshEditor(mesh).split_face(FaceId(0), centre(mesh, FaceId(0)));
  MeshEditor(mesh).split_face(FaceId(1), Vec3(0.5, 0.5, 1));
  require_valid(mesh);
  CHECK(compute_mesh_summary(mesh).euler_characteristic == 2);
}

TEST_CASE("mesh editor: splitting an edge of a pillow gives two edges between the same two vertices") {
  for (int corner = 0; corner < 3; ++corner) {
    Mesh mesh = test::make_pillow();
    const HalfedgeId h = Mesh::halfedge(FaceId(0), corner);
    const VertexId v = MeshEditor(mesh).split_edge(h, middle(mesh, h));
    // No list of faces can tell the two edges apart, so that the mesh can't be built anew to compare.
    CHECK(compute_mesh_summary(mesh).euler_characteristic == 2);
    for (int i = 0; i < mesh.halfedge_count(); ++i) {
      REQUIRE(mesh.twin(mesh.twin(HalfedgeId(i))) == HalfedgeId(i));
      REQUIRE(mesh.from(mesh.twin(HalfedgeId(i))) == mesh.to(HalfedgeId(i)));
    }
    int faces = 0;
    for_each_outgoing(mesh, v, [&](HalfedgeId) { ++faces; });
    CHECK(faces == 4);
  }
}

TEST_CASE("mesh editor: random splits and flips keep every family valid, with its area and topology") {
  for (const auto& [name, original] : test::small_family()) {
    INFO(name);
    Mesh mesh = original;
    test::Random random(3);
    for (int step = 0; step < 60; ++step) {
      const FaceId f(random.below(mesh.face_count()));
      const HalfedgeId h = Mesh::halfedge(f, random.below(3));
      if (random.below(2) == 0) {
        MeshEditor(mesh).split_face(f, centre(mesh, f));
      } else {
        MeshEditor(mesh).split_edge(h, middle(mesh, h));
        // The edge from the new vertex to the opposite corner lies within one flat face: its flip is undone at once.
        const HalfedgeId inner = Mesh::halfedge(f, 1);
        if (mesh.twin(inner).valid() && step % 7 == 0) {
          MeshEditor(mesh).flip_edge(inner);
          MeshEditor(mesh).flip_edge(Mesh::halfedge(Mesh::face(inner), 2));
        }
      }
    }
    require_valid(mesh);
    const MeshSummary before = compute_mesh_summary(original), after = compute_mesh_summary(mesh);
    CHECK(after.area == Approx(before.area).epsilon(1e-9));
    CHECK(after.euler_characteristic == before.euler_characteristic);
    CHECK(after.components == before.components);
    CHECK(after.boundary_loops == before.boundary_loops);
  }
}

}  // namespace gvd::test_mesh_editor
