#include "diagram/assembly/find_pairs_to_unite.hpp"
#include "support/catch.hpp"
#include "support/face_polygon.hpp"

namespace gvd::test_find_pairs_to_unite {

FacePolygon polygon_of(const std::vector<int>& labels) {
  std::vector<std::pair<double, int>> positions;
  for (std::size_t i = 0; i < labels.size(); ++i)
    positions.emplace_back(3 * (static_cast<double>(i) + 0.5) / static_cast<double>(labels.size()), labels[i]);
  return test::polygon_of(test::boundary_of(positions));
}

TEST_CASE("pairs cross where their ends alternate; nested, disjoint and touching pairs do not") {
  const IntervalPair pair{0, 2, 6};
  CHECK(pair.crosses({0, 0, 4}));
  CHECK(pair.crosses({0, 3, 7}));
  CHECK_FALSE(pair.crosses({0, 3, 5}));
  CHECK_FALSE(pair.crosses({0, 0, 7}));
  CHECK_FALSE(pair.crosses({0, 0, 1}));
  CHECK_FALSE(pair.crosses({0, 2, 4}));
  CHECK_FALSE(pair.crosses({0, 4, 6}));
}

TEST_CASE("where every label comes once, there is no pair") {
  test::PointDistances distances;
  distances.points = {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)};
  CHECK(find_pairs_to_unite(polygon_of({0, 1, 2}), distances).empty());
}

TEST_CASE("the generator that is nearest between its intervals is united") {
  test::PointDistances distances;
  distances.confirms = false;
  for (const int near : {0, 1}) {
    distances.points = {Vec2(near == 0 ? 0.3 : 5, 0.3), Vec2(near == 1 ? 0.3 : 5, 0.3)};
    const auto pairs = find_pairs_to_unite(polygon_of({0, 1, 0, 1}), distances);
    REQUIRE(pairs.size() == 1);
    CHECK(pairs[0].i == static_cast<std::size_t>(near));
    CHECK(pairs[0].j == static_cast<std::size_t>(near) + 2);
    CHECK(pairs[0].excess < 0);
  }
}

TEST_CASE("a pair that is not nearest is united only where a pair must be") {
  test::PointDistances distances;
  distances.points = {Vec2(9, 9), Vec2(0.3, 0.3), Vec2(0.4, 0.3)};
  distances.confirms = false;
  CHECK(find_pairs_to_unite(polygon_of({0, 1, 0, 2}), distances).empty());  // 1 and 2 can have branch points with 0
  distances.confirms = true;
  REQUIRE(find_pairs_to_unite(polygon_of({0, 1, 0, 2}), distances).size() == 1);
  CHECK(find_pairs_to_unite(polygon_of({0, 1, 0, 2}), distances)[0].excess > 0);
}

TEST_CASE("no two of the pairs cross, and they come in the order of their excess") {
  test::PointDistances distances;
  distances.points = {Vec2(0.3, 0.3), Vec2(0.31, 0.3)};
  const auto pairs = find_pairs_to_unite(polygon_of({0, 1, 0, 1, 0, 1, 0, 1}), distances);
  REQUIRE(pairs.size() > 1);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      CHECK_FALSE(pairs[i].crosses(pairs[j]));
      CHECK(pairs[j].excess <= pairs[i].excess);
    }
  }
}

TEST_CASE("two intervals are united through a narrow channel, and those that it parts are not") {
  // Generator 1 is nearest in a channel of a twentieth of the face, and generator 0 everywhere else.
  class Channel final : public test::PointDistances {
   public:
    double at(GeneratorId g, const Bary& p) const override {
      const double from_middle = std::abs(affine_point(p).y() - affine_point(p).x() - 0.1);
      return g == GeneratorId(0) ? 1 : 1 + 10 * (from_middle - 0.025);
    }
  } distances;
  // The channel leads from side 1 to side 2, beside corner 0.
  const FacePolygon polygon = test::polygon_of(test::boundary_of({{1.5375, 1}, {1.5625, 0}, {2.875, 1}, {2.925, 0}}));
  const auto pairs = find_pairs_to_unite(polygon, distances);
  REQUIRE(pairs.size() == 1);
  CHECK(polygon[pairs[0].i].next == GeneratorId(1));
}

}  // namespace gvd::test_find_pairs_to_unite
