#include <limits>

#include "diagram/assembly/branch_search.hpp"
#include "support/catch.hpp"
#include "support/face_polygon.hpp"

namespace gvd::test_branch_search {

/// A face with the labels 0, 1, 2 round it, and the distances from three points that enter it straight.
struct ThreeCells {
  std::vector<BoundaryCrossing> boundary = test::boundary_of({{0.5, 1}, {1.5, 2}, {2.5, 0}});
  FacePolygon polygon = test::polygon_of(boundary);
  test::PointDistances distances;
  LabelIntervals intervals{boundary, distances};
  BranchSearch search{distances, intervals};

  ThreeCells() {
    distances.points = {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)};
    distances.entries = {0.0, 1.0, 2.0};
    distances.equal = Bary{0.2, 0.4, 0.4};
  }
};

TEST_CASE("distances that can't confirm find no branch point, and are not asked") {
  ThreeCells face;
  face.distances.confirms = false;
  CHECK_FALSE(face.search.find_confirmed(face.polygon));
  CHECK(face.distances.searches == 0);
}

TEST_CASE("two intervals of one generator on both sides have no branch point") {
  ThreeCells face;
  face.polygon[2].next = GeneratorId(2);  // before and after interval 0, and so on: never three different
  face.polygon[0].next = GeneratorId(2);
  CHECK_FALSE(face.search.find_confirmed(face.polygon));
}

TEST_CASE("a confirmed branch point is found as it is") {
  ThreeCells face;
  const auto found = face.search.find_confirmed(face.polygon);
  REQUIRE(found);
  CHECK(found->corner == 0);
  CHECK(found->point == *face.distances.equal);
}

TEST_CASE("a point that the distances refuse, or whose path enters elsewhere, is not confirmed") {
  ThreeCells refused;
  refused.distances.is_branch = false;
  CHECK_FALSE(refused.search.find_confirmed(refused.polygon));
  ThreeCells elsewhere;
  elsewhere.distances.entries[1] = 2.0;  // through cell 2
  CHECK_FALSE(elsewhere.search.find_confirmed(elsewhere.polygon));
}

TEST_CASE("a search that failed is not repeated until it is cleared") {
  ThreeCells face;
  face.distances.is_branch = false;
  CHECK_FALSE(face.search.find_confirmed(face.polygon));
  const int searches = face.distances.searches;
  REQUIRE(searches > 0);
  face.distances.is_branch = true;
  CHECK_FALSE(face.search.find_confirmed(face.polygon));
  CHECK(face.distances.searches == searches);
  face.search.clear_failed_searches();
  CHECK(face.search.find_confirmed(face.polygon));
}

TEST_CASE("a guess outside of the face is searched again from the corners; one inside is kept") {
  ThreeCells face;
  CHECK(face.search.guess(face.polygon, 0, {0.3, 0.3, 0.4}) == face.distances.equal);
  CHECK(face.distances.searches == 1);
  face.distances.equal = Bary{-0.5, 0.75, 0.75};
  CHECK(face.search.guess(face.polygon, 0, {0.3, 0.3, 0.4}) == face.distances.equal);
  CHECK(face.distances.searches == 1 + 1 + 3 + 3);
  face.distances.confirms = false;
  face.search.guess(face.polygon, 0, {0.3, 0.3, 0.4});
  CHECK(face.distances.searches == 1 + 7 + 1);
}

TEST_CASE("clearance: how much farther the others are, without others infinite, without a point the lowest") {
  ThreeCells face;
  CHECK(face.search.clearance(face.polygon, 0) == std::numeric_limits<double>::infinity());
  face.polygon.push_back(face.polygon[2]);
  face.polygon[3].next = GeneratorId(3);
  face.distances.points.emplace_back(0.4, 0.5);
  const double own = face.distances.at(GeneratorId(2), *face.distances.equal);
  CHECK(face.search.clearance(face.polygon, 1) == Approx(0.1 - own));
  face.distances.equal = Bary{-1, 1, 1};
  CHECK(face.search.clearance(face.polygon, 1) == std::numeric_limits<double>::lowest());
  face.distances.equal = std::nullopt;
  CHECK(face.search.clearance(face.polygon, 1) == std::numeric_limits<double>::lowest());
}

}  // namespace gvd::test_branch_search
