// Trees of shortest paths, dual graphs without their leaves, and the loops that they give.
#include <cmath>
#include <numbers>

#include "repair/cell_topology.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_cell_loops {

/// A mesh that is not cut, with one label for each face.
CutMesh make_cut(const Mesh& mesh, const std::vector<int>& labels) {
  CutMesh cut;
  cut.mesh = mesh;
  for (int f = 0; f < mesh.face_count(); ++f) {
    cut.parent.push_back(FaceId(f));
    cut.label.push_back(GeneratorId(labels[f]));
  }
  return cut;
}

TEST_CASE("cell tree: before the first cell, and for a root without faces of the cell") {
  const CutMesh cut = make_cut(test::make_grid(1, 1), {0, 0});
  CellTree tree(cut);
  CHECK(std::isinf(tree.distance(VertexId(0))));
  CHECK(tree.path_to_root(VertexId(3)) == std::vector<VertexId>{VertexId(3)});
  tree.grow(VertexId(0), GeneratorId(1));
  CHECK(tree.distance(VertexId(0)) == 0);
  CHECK(std::isinf(tree.distance(VertexId(1))));
}

TEST_CASE("cell tree: it stays in the cell, and a new one replaces it") {
  // A strip of three squares; the middle one is another cell.
  const CutMesh cut = make_cut(test::make_grid(3, 1), {0, 0, 1, 1, 0, 0});
  CellTree tree(cut);
  tree.grow(VertexId(0), GeneratorId(0));
  CHECK(tree.distance(VertexId(1)) == 1);
  CHECK(tree.distance(VertexId(5)) == Approx(std::sqrt(2)));
  CHECK(std::isinf(tree.distance(VertexId(3))));
  tree.grow(VertexId(2), GeneratorId(1));
  CHECK(std::isinf(tree.distance(VertexId(0))));
  CHECK(tree.distance(VertexId(1)) == 1);
  CHECK(tree.path_to_root(VertexId(1)) == std::vector<VertexId>{VertexId(1), VertexId(2)});
}

TEST_CASE("cell tree: distances are those of the paths, and no edge offers a shorter one") {
  for (const auto& [name, mesh] : test::small_family()) {
    CAPTURE(name);
    const Diagram diagram = compute_diagram(mesh, test::random_generators(mesh, 4, 1));
    const CutMesh cut = cut_faces(mesh, diagram);
    const GeneratorId cell(0);
    const FaceId first(std::find(cut.label.begin(), cut.label.end(), cell) - cut.label.begin());
    CellTree tree(cut);
    const VertexId root = cut.mesh.vertices(first)[0];
    tree.grow(root, cell);
    int tree_edges = 0, reached = 0;
    for (int v = 0; v < cut.mesh.vertex_count(); ++v) {
      if (std::isinf(tree.distance(VertexId(v)))) continue;
      ++reached;
      const auto path = tree.path_to_root(VertexId(v));
      REQUIRE(path.back() == root);
      double length = 0;
      for (std::size_t i = 1; i < path.size(); ++i) {
        length += (cut.mesh.position(path[i]) - cut.mesh.position(path[i - 1])).norm();
      }
      CHECK(tree.distance(VertexId(v)) == Approx(length).margin(1e-12));
    }
    for (int e = 0; e < cut.mesh.edge_count(); ++e) {
      const HalfedgeId h = cut.mesh.halfedge(EdgeId(e)), twin = cut.mesh.twin(h);
      tree_edges += tree.contains_edge(h);
      if (!is_in_cell(cut, h, cell) && !(twin.valid() && is_in_cell(cut, twin, cell))) continue;
      const double from = tree.distance(cut.mesh.from(h)), to = tree.distance(cut.mesh.to(h));
      CHECK(std::abs(from - to) <= cut.mesh.length(h) + 1e-12);
    }
    CHECK(tree_edges == reached - 1);
  }
}

/// Links are numbered by their halfedges.
std::vector<int> remaining(std::size_t faces, const std::vector<std::array<int, 2>>& links) {
  std::vector<DualLink> numbered;
  for (const std::array<int, 2>& nodes : links) numbered.push_back({HalfedgeId(numbered.size()), nodes});
  std::vector<int> result;
  for (const HalfedgeId h : prune_leaves(faces, numbered)) result.push_back(h.value());
  return result;
}

constexpr int kOut = DualLink::kOutside;

TEST_CASE("dual graph: without faces, without links, and one face at the border") {
  CHECK(remaining(0, {}).empty());
  CHECK(remaining(3, {}).empty());
  CHECK(remaining(1, {{0, kOut}}).empty());
}

TEST_CASE("dual graph: a tree is pruned whole, whichever order its links have") {
  CHECK(remaining(5, {{0, 1}, {1, 2}, {2, 3}, {2, 4}}).empty());
  CHECK(remaining(5, {{2, 4}, {0, 1}, {2, 3}, {1, 2}}).empty());
  CHECK(remaining(3, {{0, 1}, {1, 2}, {2, kOut}}).empty());  // rooted outside
}

TEST_CASE("dual graph: a cycle remains, its branches do not") {
  CHECK(remaining(6, {{0, 1}, {1, 2}, {2, 0}, {2, 3}, {3, 4}, {3, 5}}) == std::vector<int>{0, 1, 2});
}

TEST_CASE("dual graph: a path between two borders remains, and so does one between two cycles") {
  CHECK(remaining(4, {{kOut, 0}, {0, 1}, {1, kOut}, {1, 2}, {2, 3}}) == std::vector<int>{0, 1, 2});
  CHECK(remaining(7, {{0, 1}, {1, 2}, {2, 0}, {2, 3}, {3, 4}, {4, 5}, {5, 6}, {6, 4}}).size() == 8);
}

TEST_CASE("dual graph: a link from a cycle to the border remains") {
  CHECK(remaining(3, {{0, 1}, {1, 2}, {2, 0}}).size() == 3);
  CHECK(remaining(3, {{0, 1}, {1, 2}, {2, 0}, {2, kOut}}).size() == 4);
}

std::vector<SurfacePoint> find_loop(const Mesh& mesh, const std::vector<SurfacePoint>& generators, int cell = 0) {
  const Diagram diagram = compute_diagram(mesh, generators);
  return CellLoops(mesh, diagram, cut_faces(mesh, diagram)).find(GeneratorId(cell));
}

TEST_CASE("cell loops: a disc and a closed sphere have none, however small") {
  const Mesh triangle = test::make_triangle();
  CHECK(find_loop(triangle, {vertex_point(triangle, VertexId(0))}).empty());
  const Mesh pillow = test::make_pillow();
  CHECK(find_loop(pillow, {vertex_point(pillow, VertexId(0))}).empty());
  const Mesh sphere = test::make_sphere(2);
  CHECK(find_loop(sphere, {vertex_point(sphere, VertexId(0))}).empty());
  const Mesh grid = test::make_grid(5, 5);
  for (int cell = 0; cell < 4; ++cell) CHECK(find_loop(grid, test::random_generators(grid, 4, 1), cell).empty());
}

TEST_CASE("cell loops: a cell round a cylinder is divided in thirds round it") {
  const Mesh ring = test::make_ring(24, 6);
  const SurfacePoint generator = vertex_point(ring, VertexId(3));
  const auto points = find_loop(ring, {generator});
  REQUIRE(points.size() == 2);
  // The generator lies on the loop: the three are a third of the way round apart.
  std::vector<Vec3> corners{position(ring, generator), position(ring, points[0]), position(ring, points[1])};
  for (std::size_t i = 0; i < 3; ++i) {
    Vec3 a = corners[i], b = corners[(i + 1) % 3];
    a.z() = b.z() = 0;
    CHECK(std::acos(std::clamp(a.normalized().dot(b.normalized()), -1.0, 1.0)) ==
          Approx(2 * std::numbers::pi / 3).epsilon(0.05));
  }
}

TEST_CASE("cell loops: of two loops of a torus the shorter one is found") {
  const Mesh torus = test::make_torus(24, 12);
  const auto points = find_loop(torus, {vertex_point(torus, VertexId(0))});
  REQUIRE(points.size() >= 2);
  const Vec3 start = torus.position(VertexId(0));
  for (const SurfacePoint& p : points) CHECK((position(torus, p) - start).norm() < 3 * 0.35);
}

TEST_CASE("cell loops: far from the generator the loop gets three points of its own") {
  // A wide tube with a thin neck at its far end: the shortest way round, there and back included, is at the neck.
  const Mesh tube = [] {
    const Mesh ring = test::make_ring(12, 40);
    std::vector<Vec3> positions = ring.positions();
    for (Vec3& p : positions) {
      const double width = p.z() < 0.4 ? 4 : 0.2;
      p = Vec3(width * p.x(), width * p.y(), 10 * p.z());
    }
    std::vector<std::array<VertexId, 3>> faces;
    for (int f = 0; f < ring.face_count(); ++f) faces.push_back(ring.vertices(FaceId(f)));
    return Mesh(std::move(positions), std::move(faces));
  }();
  const auto points = find_loop(tube, {vertex_point(tube, VertexId(0))});
  REQUIRE(points.size() == 3);
  for (const SurfacePoint& p : points) CHECK(position(tube, p).z() > 3.8);  // at the neck, or where it begins
}

TEST_CASE("cell loops: exactly the cells that are no discs have one, on every family") {
  for (const auto& [name, mesh] : test::small_family()) {
    for (const int count : {1, 2, 6}) {
      CAPTURE(name, count);
      const Diagram diagram = compute_diagram(mesh, test::random_generators(mesh, count, 3));
      CellLoops loops(mesh, diagram, cut_faces(mesh, diagram));
      for (const Cell& cell : diagram.cells) {
        const bool is_disc_or_sphere = cell.components == 1 && cell.euler_characteristic >= 1;
        const auto points = loops.find(cell.generator);
        CHECK(points.empty() == is_disc_or_sphere);
        for (const SurfacePoint& p : points) CHECK((p.face.valid() && p.face.value() < mesh.face_count()));
      }
    }
  }
}

}  // namespace gvd::test_cell_loops
