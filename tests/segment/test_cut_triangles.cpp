#include <map>
#include <set>

#include "cut_triangles.hpp"
#include "support/catch.hpp"

namespace gvd::test_cut_triangles {

/// Triangles with their parents and polygons; vertices on a circle, so that all are different.
CutTriangles make_cut(const std::vector<std::array<int, 3>>& faces, const std::vector<int>& parents,
                      const std::vector<int>& polygons) {
  CutTriangles cut;
  for (int v = 0; v < 8; ++v) cut.positions.emplace_back(std::cos(v), std::sin(v), 0);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const auto& [a, b, c] = faces[i];
    cut.triangles.push_back(
        {{VertexId(a), VertexId(b), VertexId(c)}, FaceId(parents[i]), GeneratorId(polygons[i]), polygons[i]});
  }
  return cut;
}

int largest_edge_count(const CutTriangles& cut) {
  std::map<std::pair<VertexId, VertexId>, int> count;
  int largest = 0;
  for (const CutTriangle& t : cut.triangles) {
    for (int i = 0; i < 3; ++i) largest = std::max(largest, ++count[std::minmax(t.corners[i], t.corners[(i + 1) % 3])]);
  }
  return largest;
}

TEST_CASE("doubled edges: nothing changes without triangles, or where no edge has more than two faces") {
  CutTriangles none;
  split_doubled_edges(none);
  CHECK(none.triangles.empty());
  CutTriangles cut = make_cut({{0, 1, 2}, {0, 2, 3}}, {0, 0}, {0, 1});
  const auto triangles = cut.triangles;
  split_doubled_edges(cut);
  CHECK(cut.triangles == triangles);
  CHECK(cut.positions.size() == 8);
}

TEST_CASE("doubled edges: the cuts of two parents between the same two vertices are both split") {
  // Two faces 0 1 2 back to back, each cut from vertex 2 to vertex 3 on the side 0 1.
  CutTriangles cut = make_cut({{0, 3, 2}, {3, 1, 2}, {0, 2, 3}, {3, 2, 1}}, {0, 0, 1, 1}, {0, 1, 2, 3});
  REQUIRE(largest_edge_count(cut) == 4);
  split_doubled_edges(cut);
  CHECK(largest_edge_count(cut) == 2);
  REQUIRE(cut.triangles.size() == 8);
  CHECK(cut.positions.size() == 10);
  for (std::size_t v = 8; v < 10; ++v) {
    CHECK((cut.positions[v] - 0.5 * (cut.positions[2] + cut.positions[3])).norm() < 1e-15);
  }
  for (int t = 0; t < 8; ++t) CHECK(cut.triangles[t].parent == FaceId(t / 4));
  std::map<GeneratorId, int> faces_of_label;
  for (const CutTriangle& t : cut.triangles) ++faces_of_label[t.label];
  for (const auto& [label, count] : faces_of_label) CHECK(count == 2);
}

TEST_CASE("doubled edges: a parent that is not cut is left as it is") {
  // The cut 2 3 of parent 0 is also a side of parents 1 and 2, which are whole.
  CutTriangles cut = make_cut({{0, 3, 2}, {3, 1, 2}, {2, 3, 4}}, {0, 0, 1}, {0, 1, 2});
  split_doubled_edges(cut);
  CHECK(cut.triangles.size() == 3);  // only sides of parents that are cut are counted
}

TEST_CASE("doubled edges: equal diagonals of two polygons of one parent are both split") {
  // Polygons 0 1 2 3 and 0 4 2 5, each cut along its diagonal 0 2.
  CutTriangles cut = make_cut({{0, 1, 2}, {0, 2, 3}, {0, 4, 2}, {0, 2, 5}}, {7, 7, 7, 7}, {0, 0, 1, 1});
  split_doubled_edges(cut);
  CHECK(largest_edge_count(cut) == 2);
  CHECK(cut.triangles.size() == 8);
  std::set<std::int32_t> polygons;
  for (const CutTriangle& t : cut.triangles) polygons.insert(t.polygon);
  CHECK(polygons == std::set<std::int32_t>{0, 1});
}

/// One parent, cut in two triangles at vertices 2 and 3; vertices 0 and 1 are the input's.
CutTriangles make_square(std::vector<Vec3> positions) {
  CutTriangles cut;
  cut.positions = std::move(positions);
  const FaceId parent(0);
  cut.triangles = {{{VertexId(0), VertexId(1), VertexId(2)}, parent},
                   {{VertexId(0), VertexId(2), VertexId(3)}, parent}};
  return cut;
}

TEST_CASE("coincident corners: different corners do not move") {
  CutTriangles cut = make_square({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  const std::vector<Vec3> before = cut.positions;
  CHECK(separate_coincident_corners(cut, 2, 1e-15) == 0);
  CHECK(cut.positions == before);
}

TEST_CASE("coincident corners: an added vertex moves along the longest edge, away from one of the input") {
  CutTriangles cut = make_square({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  CHECK(separate_coincident_corners(cut, 2, 1e-3) == 1);
  CHECK(cut.positions[1] == Vec3(1, 0, 0));
  CHECK((cut.positions[2] - Vec3(1, 0, 0)).norm() == Approx(1e-3));
  CHECK(cut.positions[3] == Vec3(0, 1, 0));
}

TEST_CASE("coincident corners: vertices of the input do not move") {
  CutTriangles cut = make_square({{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  const std::vector<Vec3> before = cut.positions;
  CHECK(separate_coincident_corners(cut, 2, 1e-3) == 0);
  CHECK(cut.positions == before);
}

TEST_CASE("coincident corners: a parent whose corners all coincide is left as it is, in no round") {
  CutTriangles cut = make_square(std::vector<Vec3>(4, Vec3(1, 2, 3)));
  CHECK(separate_coincident_corners(cut, 2, 1e-3) == 0);
  CHECK(cut.positions == std::vector<Vec3>(4, Vec3(1, 2, 3)));
}

}  // namespace gvd::test_cut_triangles
