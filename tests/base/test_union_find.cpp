#include <algorithm>
#include <vector>

#include "base/union_find.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace gvd::test_union_find {

TEST_CASE("disjoint sets: at first each element is its own") {
  UnionFind sets(3);
  CHECK(sets.size() == 3);
  for (const int i : {0, 1, 2}) CHECK(sets.find(i) == i);
}

TEST_CASE("disjoint sets: the smallest member represents a set, whichever way it was united") {
  UnionFind sets(6);
  sets.unite(4, 2);
  sets.unite(2, 5);
  CHECK(sets.find(5) == 2);
  sets.unite(1, 5);
  for (const int i : {1, 2, 4, 5}) CHECK(sets.find(i) == 1);
  CHECK(sets.find(0) == 0);
  CHECK(sets.find(3) == 3);
  sets.unite(4, 4);
  CHECK(sets.find(4) == 1);
}

TEST_CASE("disjoint sets: an added element is a set of its own") {
  UnionFind sets(1);
  CHECK(sets.add() == 1);
  CHECK(sets.add() == 2);
  CHECK(sets.size() == 3);
  sets.unite(0, 2);
  CHECK(sets.find(2) == 0);
  CHECK(sets.find(1) == 1);
}

TEST_CASE("disjoint sets: the same sets as by relabelling all elements") {
  test::Random random(5);
  constexpr int kCount = 200;
  UnionFind sets(kCount);
  std::vector<int> label;
  for (int i = 0; i < kCount; ++i) label.push_back(i);
  for (int round = 0; round < 150; ++round) {
    const int i = random.below(kCount), j = random.below(kCount);
    sets.unite(i, j);
    const int from = label[std::size_t(i)], to = label[std::size_t(j)];
    std::replace(label.begin(), label.end(), std::max(from, to), std::min(from, to));
    for (int k = 0; k < kCount; ++k) REQUIRE(sets.find(k) == label[std::size_t(k)]);
  }
}

}  // namespace gvd::test_union_find
