// Some of the faces of a mesh as a mesh of their own, and meshes without the vertices that no face has.
#include <algorithm>
#include <array>
#include <functional>
#include <vector>

#include "mesh/submesh.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_submesh {

std::vector<FaceId> faces_with(const Mesh& mesh, const std::vector<int>& numbers) {
  std::vector<FaceId> faces;
  for (const int number : numbers) faces.emplace_back(number);
  for (const FaceId f : faces) REQUIRE(f.value() < mesh.face_count());
  return faces;
}

TEST_CASE("submesh: no face is an empty mesh, and one face is a triangle") {
  const Mesh grid = test::make_grid(2, 2);
  CHECK(make_submesh(grid, {}).mesh.face_count() == 0);
  const Submesh one = make_submesh(grid, {FaceId(5)});
  REQUIRE(one.mesh.face_count() == 1);
  CHECK(one.mesh.vertex_count() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(one.whole_vertex[one.mesh.vertices(FaceId(0))[i]] == grid.vertices(FaceId(5))[i]);
  }
}

TEST_CASE("submesh: all faces are the whole mesh, corner by corner") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    std::vector<FaceId> faces;
    for (const FaceId f : mesh.faces()) faces.push_back(f);
    const Submesh all = make_submesh(mesh, faces);
    CHECK(all.mesh.vertex_count() == mesh.vertex_count());
    CHECK(all.mesh.edge_count() == mesh.edge_count());
    for (const FaceId f : mesh.faces()) {
      CHECK(all.whole_face[f] == f);
      for (std::size_t i = 0; i < 3; ++i) CHECK(all.whole_vertex[all.mesh.vertices(f)[i]] == mesh.vertices(f)[i]);
    }
  }
}

TEST_CASE("submesh: points go there and back by their faces, those of other faces do not") {
  const Mesh grid = test::make_grid(3, 3);
  const Submesh part = make_submesh(grid, faces_with(grid, {2, 3, 7, 11}));
  for (const int f : {2, 3, 7, 11}) {
    const SurfacePoint point = make_surface_point(FaceId(f), {0.2, 0.3, 0.5});
    const auto there = part.to_part(point);
    REQUIRE(there);
    CHECK(position(part.mesh, *there) == position(grid, point));
    CHECK(part.to_whole(*there) == point);
  }
  for (const int f : {0, 1, 4, 12, 17}) CHECK_FALSE(part.to_part(make_surface_point(FaceId(f), {0.2, 0.3, 0.5})));
}

TEST_CASE("submesh: where faces meet at a vertex only, each fan of them has its own") {
  // The squares at two opposite corners of a grid of four, which meet in its middle.
  const Mesh grid = test::make_grid(2, 2);
  const Submesh part = make_submesh(grid, faces_with(grid, {0, 1, 6, 7}));
  CHECK(part.mesh.vertex_count() == 8);
  CHECK(std::ranges::count(part.whole_vertex, VertexId(4)) == 2);
}

TEST_CASE("submesh: a fan that begins and ends at faces outside has one vertex") {
  const Mesh sphere = test::make_sphere(2);
  const VertexId v(0);
  std::vector<FaceId> round;
  for (const FaceId f : sphere.faces()) {
    if (std::ranges::find(sphere.vertices(f), v) != sphere.vertices(f).end()) round.push_back(f);
  }
  round.erase(round.begin() + 1);
  const Submesh part = make_submesh(sphere, round);
  CHECK(std::ranges::count(part.whole_vertex, v) == 1);
}

TEST_CASE("submesh: vertices come in the order of the faces' corners, or in one that is given") {
  const Mesh grid = test::make_grid(2, 1);
  const std::vector<FaceId> faces = faces_with(grid, {2, 3});
  const Submesh plain = make_submesh(grid, faces);
  CHECK(plain.whole_vertex[VertexId(0)] == grid.vertices(FaceId(2))[0]);
  IdVector<VertexId, VertexId> backwards;
  for (const VertexId v : grid.vertices()) backwards.push_back(VertexId(grid.vertex_count() - 1 - v.value()));
  const Submesh ordered = make_submesh(grid, faces, backwards);
  CHECK(std::is_sorted(ordered.whole_vertex.begin(), ordered.whole_vertex.end(), std::greater<>()));
  for (const FaceId f : ordered.mesh.faces()) {
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(ordered.whole_vertex[ordered.mesh.vertices(f)[i]] == plain.whole_vertex[plain.mesh.vertices(f)[i]]);
    }
  }
}

TEST_CASE("submesh: every second face of each family is an oriented manifold with the faces' corners") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    std::vector<FaceId> faces;
    for (std::int32_t f = 0; f < mesh.face_count(); f += 2) faces.emplace_back(f);
    const Submesh part = make_submesh(mesh, faces);  // a mesh checks that it is a manifold
    for (const FaceId f : part.mesh.faces()) {
      for (std::size_t i = 0; i < 3; ++i) {
        CHECK(part.mesh.position(part.mesh.vertices(f)[i]) == mesh.position(mesh.vertices(faces[f.index()])[i]));
      }
    }
  }
}

TEST_CASE("unused vertices: without faces all go, and a triangle of all vertices stays as it is") {
  std::vector<std::array<VertexId, 3>> faces;
  const KeptVertices none = drop_unused_vertices(2, faces);
  CHECK(none.before.empty());
  CHECK(none.after == IdVector<VertexId, VertexId>(2));
  faces = {{VertexId(2), VertexId(0), VertexId(1)}};
  const auto same = faces;
  CHECK(drop_unused_vertices(3, faces).before.size() == 3);
  CHECK(faces == same);
}

TEST_CASE("unused vertices: those that stay keep their order, and the faces their corners") {
  std::vector<std::array<VertexId, 3>> faces{{VertexId(6), VertexId(1), VertexId(3)},
                                             {VertexId(1), VertexId(6), VertexId(4)}};
  const auto former = faces;
  const KeptVertices kept = drop_unused_vertices(8, faces);
  CHECK(kept.before.raw() == std::vector<VertexId>{VertexId(1), VertexId(3), VertexId(4), VertexId(6)});
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (std::size_t i = 0; i < 3; ++i) CHECK(kept.before[faces[f][i]] == former[f][i]);
  }
  for (const VertexId v : kept.after.ids()) {
    const bool is_used = std::ranges::find(kept.before, v) != kept.before.end();
    CHECK(kept.after[v].valid() == is_used);
    if (is_used) CHECK(kept.before[kept.after[v]] == v);
  }
}

}  // namespace gvd::test_submesh
