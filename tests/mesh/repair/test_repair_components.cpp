#include "mesh/repair/repair_steps.hpp"
#include "support/catch.hpp"

namespace gvd::test_repair_components {

TEST_CASE("pair_halfedges: the two of an edge, whatever their direction; none on the boundary") {
  WorkFaces work;
  work.faces = {{0, 1, 2}, {1, 0, 3}, {1, 2, 4}};
  const EdgeTable nonmanifold_edges = pair_halfedges(work, 5);
  CHECK(nonmanifold_edges.empty());
  CHECK(work.twin == std::vector<std::int32_t>{3, 6, -1, 0, -1, -1, 1, -1, -1});
}

TEST_CASE("pair_halfedges: an edge of three faces stays unpaired and is returned") {
  WorkFaces work;
  work.faces = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {1, 2, 5}};
  const EdgeTable nonmanifold_edges = pair_halfedges(work, 6);
  REQUIRE(nonmanifold_edges.size() == 1);
  CHECK(nonmanifold_edges[0].size() == 3);
  CHECK(nonmanifold_edges[0] == std::vector<std::int32_t>{0, 3, 6});
  CHECK(work.twin[0] == -1);
  CHECK(work.twin[1] == 9);
}

TEST_CASE("work faces: halfedges of a face") {
  WorkFaces work;
  work.faces = {{4, 5, 6}, {7, 8, 9}};
  CHECK(work.halfedge_count() == 6);
  CHECK(WorkFaces::next(5) == 3);
  CHECK(WorkFaces::previous(3) == 5);
  CHECK(work.from(5) == 9);
  CHECK(work.to(5) == 7);
}

}  // namespace gvd::test_repair_components
