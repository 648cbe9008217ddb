#include <algorithm>
#include <limits>
#include <utility>

#include "diagram/assembly/branch_points.hpp"
#include "diagram/assembly/face_distances.hpp"
#include "diagram/assembly/face_polygon.hpp"
#include "support/catch.hpp"
#include "support/face_polygon.hpp"
#include "support/random.hpp"

namespace gvd::test_branch_points {

/// A face with the labels 0, 1, 2 round it, and the distances from three points that enter it straight.
struct ThreeCells {
  std::vector<BoundaryCrossing> boundary = test::boundary_of({{0.5, 1}, {1.5, 2}, {2.5, 0}});
  FacePolygon polygon = test::polygon_of(boundary);
  test::PointDistances distances;
  LabelIntervals intervals{boundary};
  BranchSearch search{distances, &distances, intervals};
  BranchSearch guesses{distances, nullptr, intervals};

  ThreeCells() {
    distances.points = {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)};
    distances.entries = {0.0, 1.0, 2.0};
    distances.equal = Bary{0.2, 0.4, 0.4};
  }
};

TEST_CASE("without paths no branch point is confirmed, and the distances are not asked") {
  ThreeCells face;
  CHECK_FALSE(face.guesses.find_confirmed(face.polygon));
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

TEST_CASE("a guess outside of the face is searched again from the corners, one inside is kept") {
  ThreeCells face;
  CHECK(face.search.guess(face.polygon, 0, {0.3, 0.3, 0.4}) == face.distances.equal);
  CHECK(face.distances.searches == 1);
  face.distances.equal = Bary{-0.5, 0.75, 0.75};
  CHECK(face.search.guess(face.polygon, 0, {0.3, 0.3, 0.4}) == face.distances.equal);
  CHECK(face.distances.searches == 1 + 1 + 3 + 3);
  face.guesses.guess(face.polygon, 0, {0.3, 0.3, 0.4});
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

const FacePolygon kThree = test::polygon_of(test::boundary_of({{0.5, 1}, {1.5, 2}, {2.5, 0}}));
const FacePolygon kFive = test::polygon_of(test::boundary_of({{0.3, 1}, {0.7, 2}, {1.5, 3}, {2.3, 4}, {2.7, 0}}));

double least(const Bary& p) { return *std::min_element(p.begin(), p.end()); }

TEST_CASE("without a guess a branch point lies in the centre") {
  CHECK(place_in_face(kThree, std::nullopt, false) == centre(kThree));
  CHECK(place_in_polygon(kThree, std::nullopt, false) == centre(kThree));
}

TEST_CASE("a valid guess is not moved") {
  for (const bool is_accurate : {false, true}) {
    const Bary corner_of_face{0.98, 0.01, 0.01};
    CHECK(place_in_face(kThree, corner_of_face, is_accurate) == corner_of_face);
    CHECK(place_in_polygon(kThree, Bary{0.3, 0.3, 0.4}, is_accurate) == Bary{0.3, 0.3, 0.4});
  }
}

TEST_CASE("a guess on a side stays there to rounding where it is accurate, and keeps clear of it where it is not") {
  const Bary on_side{0.5, 0.5, 0};
  const Bary rough = place_in_face(kThree, on_side, false);
  const Bary accurate = place_in_face(kThree, on_side, true);
  CHECK(least(rough) > 0.01);
  CHECK(least(accurate) > 0);
  CHECK(least(accurate) < kInsideFace);
  CHECK(place_in_face(kThree, Bary{0.5, 0.5 - kInsideFace, kInsideFace}, true)[2] == kInsideFace);
}

// In a thin face, a ten-thousandth of its height is a distance that rounding and ties account for.
TEST_CASE("an accurate guess a little outside stays as near as it was beyond") {
  for (const double beyond : {1e-10, 1e-8, 1e-6, 1e-4}) {
    const Bary wanted{0.5, 0.5 + beyond, -beyond};
    const Bary p = place_in_face(kThree, wanted, true);
    CHECK(least(p) > 0);
    CHECK(bary_distance(p, wanted) < 4 * beyond + 1e-11);
    CHECK(least(place_in_face(kThree, wanted, false)) > 0.01);
  }
}

TEST_CASE("an accurate guess beside the end of a sliver stays at that end") {
  FacePolygon sliver = kThree;
  const Bary end{0, 0.5, 0.5};
  sliver[0].bary = mix(end, Bary{1, 0, 0}, 1e-7);
  sliver[1].bary = end;
  sliver[2].bary = {0.5, 0, 0.5};
  if (!is_convex({sliver[0].bary, sliver[1].bary, sliver[2].bary}, 0)) std::swap(sliver[0].bary, sliver[1].bary);
  for (const Bary& wanted :
       {Bary{-1e-7, 0.5 + 1e-7, 0.5}, Bary{1e-7, 0.5 + 1e-7, 0.5 - 2e-7}, Bary{1e-7, 0.5 - 3e-7, 0.5 + 2e-7}}) {
    const Bary p = place_in_polygon(sliver, wanted, true);
    CHECK(is_inside(sliver, p, kTieInversion));
    CHECK(bary_distance(p, end) < 1e-6);
  }
}

TEST_CASE("a guess far outside keeps clear of the limit") {
  const Bary p = place_in_polygon(kThree, Bary{-5, 3, 3}, false);
  CHECK(is_inside(kThree, p, 0));
  CHECK(least(p) > 0.01);
  CHECK(bary_distance(p, centre(kThree)) > 0.05);
}

TEST_CASE("a branch point at an interval leaves a convex polygon, wherever it is wanted") {
  test::Random random(9);
  for (const bool is_accurate : {false, true}) {
    for (int round = 0; round < 500; ++round) {
      const std::size_t i = static_cast<std::size_t>(random.below(5));
      const double u = random.real(-2, 2), v = random.real(-2, 2);
      const Bary p = place_at_interval(kFive, i, Bary{u, v, 1 - u - v}, is_accurate);
      std::vector<Bary> rest{p};
      for (std::size_t k = 2; k < 5; ++k) rest.push_back(kFive[(i + k) % 5].bary);
      REQUIRE(is_convex(rest, is_accurate ? kTieInversion : 0));
      REQUIRE(is_inside(kFive, p, is_accurate ? kTieInversion : 0));
    }
  }
}

}  // namespace gvd::test_branch_points
