#include <cmath>

#include "repair/cell_tree.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

namespace gvd::test_cell_tree {

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

}  // namespace gvd::test_cell_tree
