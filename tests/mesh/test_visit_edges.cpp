#include <array>
#include <map>
#include <utility>
#include <vector>

#include "mesh/visit_edges.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace gvd::test_visit_edges {

using Triangles = std::vector<std::array<int, 3>>;
using Edge = std::pair<int, int>;

/// The edges in the order of the visit, with their halfedges.
std::vector<std::pair<Edge, std::vector<int>>> visited(const Triangles& faces, std::size_t vertices) {
  std::vector<std::pair<Edge, std::vector<int>>> result;
  visit_edges(faces, vertices, [&](const EdgeHalfedges& edge) {
    std::vector<int> halfedges;
    for (std::size_t i = 0; i < edge.size(); ++i) halfedges.push_back(edge[i]);
    const auto& face = faces[std::size_t(edge[0] / 3)];
    const Edge ends = std::minmax(face[std::size_t(edge[0] % 3)], face[std::size_t((edge[0] + 1) % 3)]);
    result.emplace_back(ends, halfedges);
  });
  return result;
}

TEST_CASE("visit_edges: no face, and one") {
  CHECK(visited({}, 0).empty());
  const auto edges = visited({{2, 0, 1}}, 3);
  REQUIRE(edges.size() == 3);
  CHECK(edges[0] == std::pair(Edge{0, 1}, std::vector<int>{1}));
  CHECK(edges[1] == std::pair(Edge{0, 2}, std::vector<int>{0}));
  CHECK(edges[2] == std::pair(Edge{1, 2}, std::vector<int>{2}));
}

TEST_CASE("visit_edges: an edge of three faces, whatever their directions, with ascending halfedges") {
  const auto edges = visited({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}, 5);
  CHECK(edges.front() == std::pair(Edge{0, 1}, std::vector<int>{0, 3, 6}));
  CHECK(edges.size() == 7);
}

TEST_CASE("visit_edges: random triangles, as a sorted map of edges") {
  test::Random random(12);
  for (const int count : {5, 40, 300}) {
    constexpr int kVertices = 20;
    Triangles faces;
    std::map<Edge, std::vector<int>> expected;
    while (int(faces.size()) < count) {
      const int a = random.below(kVertices), b = random.below(kVertices), c = random.below(kVertices);
      if (a == b || b == c || c == a) continue;
      const int h = 3 * int(faces.size());
      faces.push_back({a, b, c});
      expected[std::minmax(a, b)].push_back(h);
      expected[std::minmax(b, c)].push_back(h + 1);
      expected[std::minmax(c, a)].push_back(h + 2);
    }
    const auto edges = visited(faces, kVertices);
    REQUIRE(edges.size() == expected.size());
    REQUIRE(std::equal(edges.begin(), edges.end(), expected.begin(),
                       [](const auto& a, const auto& b) { return a.first == b.first && a.second == b.second; }));
  }
}

}  // namespace gvd::test_visit_edges
