// Polygons and triangles while they are repaired.
#include <cstdint>
#include <vector>

#include "mesh/repair/work_faces.hpp"
#include "support/catch.hpp"

namespace gvd::test_work_faces {

std::vector<std::int32_t> corners_of(const WorkPolygons& work, std::size_t p) {
  const auto polygon = work.polygon(p);
  return {polygon.begin(), polygon.end()};
}

void add(WorkPolygons& work, const std::vector<std::int32_t>& corners, std::int32_t from) {
  work.corners.insert(work.corners.end(), corners.begin(), corners.end());
  work.close(from);
}

TEST_CASE("work polygons: each one has the corners that were appended since the last one, and its origin") {
  WorkPolygons work;
  CHECK(work.count() == 0);
  add(work, {4, 1, 2}, 7);
  add(work, {3, 2, 1, 0, 8, 9}, 9);
  add(work, {5, 6, 7}, 9);  // two parts of one polygon of the soup
  REQUIRE(work.count() == 3);
  CHECK(corners_of(work, 0) == std::vector<std::int32_t>{4, 1, 2});
  CHECK(corners_of(work, 1) == std::vector<std::int32_t>{3, 2, 1, 0, 8, 9});
  CHECK(corners_of(work, 2) == std::vector<std::int32_t>{5, 6, 7});
  CHECK(work.origin == std::vector<std::int32_t>{7, 9, 9});
}

TEST_CASE("work polygons: corners that belong to no polygon yet change none, and a polygon may be empty") {
  WorkPolygons work;
  add(work, {0, 1, 2}, 0);
  work.corners.push_back(3);
  CHECK(work.count() == 1);
  CHECK(corners_of(work, 0).size() == 3);
  work.close(1);
  CHECK(corners_of(work, 1) == std::vector<std::int32_t>{3});
  work.close(2);
  CHECK(work.polygon(2).empty());
}

TEST_CASE("pair_halfedges: the two of an edge, whatever their direction, none on the boundary") {
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

}  // namespace gvd::test_work_faces
