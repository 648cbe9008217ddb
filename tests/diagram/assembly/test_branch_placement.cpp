#include <algorithm>

#include "diagram/assembly/branch_placement.hpp"
#include "diagram/assembly/face_distances.hpp"
#include "support/catch.hpp"
#include "support/face_polygon.hpp"
#include "support/random.hpp"

using namespace gvd;

namespace {

const FacePolygon kThree = test::polygon_of(test::boundary_of({{0.5, 1}, {1.5, 2}, {2.5, 0}}));
const FacePolygon kFive = test::polygon_of(test::boundary_of({{0.3, 1}, {0.7, 2}, {1.5, 3}, {2.3, 4}, {2.7, 0}}));

double least(const Bary& p) { return *std::min_element(p.begin(), p.end()); }

}  // namespace

TEST_CASE("without a guess a branch point lies in the centre") {
  const BranchPlacement placement(false);
  CHECK(placement.place_in_face(kThree, std::nullopt) == centre(kThree));
  CHECK(placement.place_in_polygon(kThree, std::nullopt) == centre(kThree));
}

TEST_CASE("a valid guess is not moved") {
  for (const bool is_accurate : {false, true}) {
    const BranchPlacement placement(is_accurate);
    const Bary corner_of_face{0.98, 0.01, 0.01};
    CHECK(placement.place_in_face(kThree, corner_of_face) == corner_of_face);
    CHECK(placement.place_in_polygon(kThree, Bary{0.3, 0.3, 0.4}) == Bary{0.3, 0.3, 0.4});
  }
}

TEST_CASE("a guess on a side stays there to rounding where it is accurate, and keeps clear of it where it is not") {
  const Bary on_side{0.5, 0.5, 0};
  const Bary rough = BranchPlacement(false).place_in_face(kThree, on_side);
  const Bary accurate = BranchPlacement(true).place_in_face(kThree, on_side);
  CHECK(least(rough) > 0.01);
  CHECK(least(accurate) > 0);
  CHECK(least(accurate) < kInsideFace);
  CHECK(BranchPlacement(true).place_in_face(kThree, Bary{0.5, 0.5 - kInsideFace, kInsideFace})[2] == kInsideFace);
}

TEST_CASE("a guess far outside keeps clear of the limit") {
  const BranchPlacement placement(false);
  const Bary p = placement.place_in_polygon(kThree, Bary{-5, 3, 3});
  CHECK(is_inside(kThree, p, 0));
  CHECK(least(p) > 0.01);
  CHECK(bary_distance(p, centre(kThree)) > 0.05);
}

TEST_CASE("a branch point at an interval leaves a convex polygon, wherever it is wanted") {
  test::Random random(9);
  for (const bool is_accurate : {false, true}) {
    const BranchPlacement placement(is_accurate);
    for (int round = 0; round < 500; ++round) {
      const std::size_t i = static_cast<std::size_t>(random.below(5));
      const double u = random.real(-2, 2), v = random.real(-2, 2);
      const Bary p = placement.place_at_interval(kFive, i, Bary{u, v, 1 - u - v});
      std::vector<Bary> rest{p};
      for (std::size_t k = 2; k < 5; ++k) rest.push_back(kFive[(i + k) % 5].bary);
      REQUIRE(is_convex(rest, is_accurate ? kTieInversion : 0));
      REQUIRE(is_inside(kFive, p, is_accurate ? kTieInversion : 0));
    }
  }
}
