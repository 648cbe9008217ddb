#include <map>
#include <set>

#include "split_doubled_edges.hpp"
#include "support/catch.hpp"

namespace gvd::test_split_doubled_edges {

/// Triangles with their parents and polygons; vertices on a circle, so that all are different.
CutTriangles make_cut(const std::vector<std::array<int, 3>>& faces, const std::vector<int>& parents,
                      const std::vector<int>& polygons) {
  CutTriangles cut;
  for (int v = 0; v < 8; ++v) cut.positions.emplace_back(std::cos(v), std::sin(v), 0);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const auto& [a, b, c] = faces[i];
    cut.faces.push_back({VertexId(a), VertexId(b), VertexId(c)});
    cut.parent.push_back(FaceId(parents[i]));
    cut.label.push_back(GeneratorId(polygons[i]));
    cut.polygon.push_back(polygons[i]);
  }
  return cut;
}

int largest_edge_count(const CutTriangles& cut) {
  std::map<std::pair<VertexId, VertexId>, int> count;
  int largest = 0;
  for (const auto& f : cut.faces) {
    for (std::size_t i = 0; i < 3; ++i) largest = std::max(largest, ++count[std::minmax(f[i], f[(i + 1) % 3])]);
  }
  return largest;
}

TEST_CASE("doubled edges: nothing changes without triangles, or where no edge has more than two faces") {
  CutTriangles none;
  split_doubled_edges(none);
  CHECK(none.faces.empty());
  CutTriangles cut = make_cut({{0, 1, 2}, {0, 2, 3}}, {0, 0}, {0, 1});
  const auto faces = cut.faces;
  split_doubled_edges(cut);
  CHECK(cut.faces == faces);
  CHECK(cut.positions.size() == 8);
}

TEST_CASE("doubled edges: the cuts of two parents between the same two vertices are both split") {
  // Two faces 0 1 2 back to back, each cut from vertex 2 to vertex 3 on the side 0 1.
  CutTriangles cut = make_cut({{0, 3, 2}, {3, 1, 2}, {0, 2, 3}, {3, 2, 1}}, {0, 0, 1, 1}, {0, 1, 2, 3});
  REQUIRE(largest_edge_count(cut) == 4);
  split_doubled_edges(cut);
  CHECK(largest_edge_count(cut) == 2);
  REQUIRE(cut.faces.size() == 8);
  CHECK(cut.positions.size() == 10);
  for (std::size_t v = 8; v < 10; ++v) {
    CHECK((cut.positions[v] - 0.5 * (cut.positions[2] + cut.positions[3])).norm() < 1e-15);
  }
  for (int f = 0; f < 8; ++f) CHECK(cut.parent[FaceId(f)] == FaceId(f / 4));
  std::map<GeneratorId, int> faces_of_label;
  for (const GeneratorId g : cut.label) ++faces_of_label[g];
  for (const auto& [label, count] : faces_of_label) CHECK(count == 2);
}

TEST_CASE("doubled edges: a parent that is not cut is left as it is") {
  // The cut 2 3 of parent 0 is also a side of parents 1 and 2, which are whole.
  CutTriangles cut = make_cut({{0, 3, 2}, {3, 1, 2}, {2, 3, 4}}, {0, 0, 1}, {0, 1, 2});
  split_doubled_edges(cut);
  CHECK(cut.faces.size() == 3);  // only sides of parents that are cut are counted
}

TEST_CASE("doubled edges: equal diagonals of two polygons of one parent are both split") {
  // Polygons 0 1 2 3 and 0 4 2 5, each cut along its diagonal 0 2.
  CutTriangles cut = make_cut({{0, 1, 2}, {0, 2, 3}, {0, 4, 2}, {0, 2, 5}}, {7, 7, 7, 7}, {0, 0, 1, 1});
  split_doubled_edges(cut);
  CHECK(largest_edge_count(cut) == 2);
  CHECK(cut.faces.size() == 8);
  std::set<std::int32_t> polygons(cut.polygon.begin(), cut.polygon.end());
  CHECK(polygons == std::set<std::int32_t>{0, 1});
}

}  // namespace gvd::test_split_doubled_edges
