// Texture coordinates on a cut mesh: exact at old corners, linear in each parent, and with the seams of the input
// alone.
#include <algorithm>
#include <cmath>
#include <random>

#include "gvd/error.hpp"
#include "gvd/segment.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

namespace gvd::test_cut_appearance {

using namespace test;

/// Random texture coordinates: those of a vertex in the charts of its faces, which are `charts` runs of faces.
Appearance make_texture(const Mesh& mesh, int charts) {
  Appearance appearance;
  std::vector<std::vector<Uv>> of_chart;
  std::mt19937 random(7);
  for (int chart = 0; chart < charts; ++chart) {
    std::vector<Uv>& of_vertex = of_chart.emplace_back();
    for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
      of_vertex.push_back({static_cast<double>(random()) / 3e9, static_cast<double>(random()) / 7e9});
    }
  }
  for (const FaceId f : mesh.faces()) {
    const auto chart = static_cast<std::size_t>(f.value()) * charts / mesh.face_vertices().size();
    for (const VertexId v : mesh.vertices(f)) appearance.texture.push_back(of_chart[chart][v.index()]);
    appearance.material.push_back(f.value() % 3 - 1);
  }
  appearance.materials = {"a", "b"};
  return appearance;
}

/// Barycentric coordinates of a point in a triangle, from its areas.
std::array<double, 3> weights_in(const Mesh& mesh, FaceId f, const Vec3& p) {
  const auto& [a, b, c] = mesh.vertices(f);
  const Vec3 &x = mesh.position(a), &y = mesh.position(b), &z = mesh.position(c);
  const Vec3 normal = (y - x).cross(z - x);
  const double square = normal.squaredNorm();
  return {(y - p).cross(z - p).dot(normal) / square, (z - p).cross(x - p).dot(normal) / square,
          (x - p).cross(y - p).dot(normal) / square};
}

/// The number of edges at whose two sides the texture coordinates differ.
int count_seams(const Mesh& mesh, const std::vector<Uv>& texture) {
  int seams = 0;
  for (const EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e), twin = mesh.twin(h);
    if (!twin.valid()) continue;
    seams += texture[h.index()] != texture[Mesh::next(twin).index()] ||
             texture[Mesh::next(h).index()] != texture[twin.index()];
  }
  return seams;
}

/// Edges of the cut mesh that lie on an edge of the input at whose sides the texture coordinates differ.
int count_seam_pieces(const Mesh& mesh, const Appearance& appearance, const CutMesh& cut) {
  int pieces = 0;
  for (const EdgeId e : cut.mesh.edges()) {
    const HalfedgeId h = cut.mesh.halfedge(e);
    if (!cut.mesh.twin(h).valid()) continue;
    const FaceId a = cut.parent[Mesh::face(h)], b = cut.parent[Mesh::face(cut.mesh.twin(h))];
    if (a == b) continue;
    for (const HalfedgeId side : Mesh::halfedges(a)) {
      const HalfedgeId twin = mesh.twin(side);
      if (!twin.valid() || Mesh::face(twin) != b) continue;
      pieces += appearance.texture[side.index()] != appearance.texture[Mesh::next(twin).index()] ||
                appearance.texture[Mesh::next(side).index()] != appearance.texture[twin.index()];
    }
  }
  return pieces;
}

void check_cut(const Mesh& mesh, const std::vector<SurfacePoint>& generators, int charts) {
  const Appearance appearance = make_texture(mesh, charts);
  const CutMesh cut = cut_faces(mesh, compute_diagram(mesh, generators));
  const Appearance carried = carry_to_cut_faces(mesh, appearance, cut);
  REQUIRE(cut.mesh.vertex_count() > mesh.vertex_count());
  REQUIRE(carried.texture.size() == static_cast<std::size_t>(cut.mesh.halfedge_count()));
  REQUIRE(carried.material.size() == static_cast<std::size_t>(cut.mesh.face_count()));
  CHECK(carried.materials == appearance.materials);
  int old_corners = 0;
  double worst = 0;
  for (const HalfedgeId h : cut.mesh.halfedges()) {
    const FaceId parent = cut.parent[Mesh::face(h)];
    const Uv& uv = carried.texture[h.index()];
    CHECK(carried.material[Mesh::face(h).index()] == appearance.material[parent.index()]);
    const auto weights = weights_in(mesh, parent, cut.mesh.position(cut.mesh.from(h)));
    for (std::size_t k = 0; k < 2; ++k) {
      double expected = 0;
      for (int i = 0; i < 3; ++i) expected += weights[i] * appearance.texture[Mesh::halfedge(parent, i).index()][k];
      worst = std::max(worst, std::abs(expected - uv[k]));
    }
    const auto& corners = mesh.vertices(parent);
    const auto corner = std::find(corners.begin(), corners.end(), cut.mesh.from(h)) - corners.begin();
    if (corner == 3 || cut.mesh.from(h).value() >= cut.input_vertices) continue;
    CHECK(uv == appearance.texture[Mesh::halfedge(parent, static_cast<int>(corner)).index()]);
    ++old_corners;
  }
  CHECK(worst < 1e-10);
  CHECK(old_corners >= mesh.halfedge_count());
  const int seams = count_seams(cut.mesh, carried.texture);
  CHECK(seams == count_seam_pieces(mesh, appearance, cut));
  CHECK((seams > 0) == (charts > 1));
}

TEST_CASE("cut appearance: exact at old corners, linear elsewhere, and no seam is added") {
  for (const int charts : {1, 2, 7}) {
    INFO(charts);
    const Mesh torus = make_torus(24, 12), grid = make_grid(6, 5), sphere = make_bumpy_sphere(2, 3);
    check_cut(torus, random_generators(torus, 15, 1), charts);
    check_cut(grid, random_generators(grid, 9, 2), charts);
    check_cut(sphere, random_generators(sphere, 40, 3), charts);
  }
}

TEST_CASE("cut appearance: a parent without texture coordinates has pieces without") {
  const Mesh mesh = make_grid(4, 3);
  Appearance appearance = make_texture(mesh, 1);
  for (const HalfedgeId h : Mesh::halfedges(FaceId(5))) appearance.texture[h.index()] = kNoTexture;
  const CutMesh cut = cut_faces(mesh, compute_diagram(mesh, random_generators(mesh, 6, 1)));
  const Appearance carried = carry_to_cut_faces(mesh, appearance, cut);
  for (const HalfedgeId h : cut.mesh.halfedges()) {
    CHECK(is_finite(carried.texture[h.index()]) == (cut.parent[Mesh::face(h)] != FaceId(5)));
  }
  appearance = {};
  CHECK(carry_to_cut_faces(mesh, appearance, cut).empty());
}

TEST_CASE("cut appearance: that of another mesh is refused") {
  const Mesh mesh = make_grid(4, 3);
  const CutMesh cut = cut_faces(mesh, compute_diagram(mesh, random_generators(mesh, 6, 1)));
  Appearance appearance = make_texture(mesh, 1);
  CHECK_THROWS_AS(carry_to_cut_faces(make_grid(1, 1), appearance, cut), Error);
  appearance.texture.pop_back();
  CHECK_THROWS_AS(carry_to_cut_faces(mesh, appearance, cut), Error);
}

}  // namespace gvd::test_cut_appearance
