#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "base/box_tree.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace gvd::test_box_tree {

Box2 box_of(const Vec2& low, const Vec2& high) { return {low, high}; }

std::vector<Box2> random_boxes(int count, unsigned seed) {
  test::Random random(seed);
  std::vector<Box2> boxes;
  for (int i = 0; i < count; ++i) {
    const Vec2 a(random.real(0, 1), random.real(0, 1));
    boxes.push_back(bounding_box(a, a + Vec2(random.real(-0.2, 0.2), random.real(-0.2, 0.2))));
  }
  return boxes;
}

BoxTree tree_of(const std::vector<Box2>& boxes) {
  BoxTree tree;
  tree.build(boxes.size(), [&](std::size_t i) { return boxes[i]; });
  return tree;
}

TEST_CASE("boxes: an empty one overlaps nothing and is neutral in a union") {
  const Box2 empty, box = box_of({0, 0}, {1, 2});
  CHECK(empty.isEmpty());
  CHECK_FALSE(box.isEmpty());
  CHECK_FALSE(empty.intersects(box));
  CHECK_FALSE(box.intersects(empty));
  CHECK_FALSE(empty.intersects(empty));
  const Box2 united = empty.merged(box);
  CHECK(united.min() == box.min());
  CHECK(united.max() == box.max());
}

TEST_CASE("boxes: those that share a border point overlap") {
  const Box2 box = box_of({0, 0}, {1, 1});
  CHECK(box.intersects(box_of({1, 1}, {2, 2})));
  CHECK(box.intersects(box_of({0.2, 0.2}, {0.3, 0.3})));
  CHECK_FALSE(box.intersects(box_of({1.01, 0}, {2, 1})));
  CHECK_FALSE(box.intersects(box_of({0, -2}, {1, -0.01})));
}

TEST_CASE("bounding_box of two points in any order") {
  const Box2 box = bounding_box({1, -1}, {0, 3});
  CHECK(box.min() == Vec2(0, -1));
  CHECK(box.max() == Vec2(1, 3));
}

TEST_CASE("box tree: none, one and two items") {
  const auto any = [](const Box2&) { return true; };
  CHECK(BoxTree().find(0, any) == BoxTree::kNone);
  CHECK(tree_of({}).find(0, any) == BoxTree::kNone);
  BoxTree one = tree_of({box_of({0, 0}, {0, 0})});
  CHECK(one.find(0, any) == 0);
  CHECK(one.find(1, any) == BoxTree::kNone);
  one.remove(0);
  CHECK(one.find(0, any) == BoxTree::kNone);
  int pairs = 0;
  tree_of({box_of({0, 0}, {1, 1}), box_of({1, 1}, {2, 2})}).visit_overlaps([&](std::size_t i, std::size_t j) {
    CHECK((i == 0 && j == 1));
    ++pairs;
  });
  CHECK(pairs == 1);
}

TEST_CASE("box tree: find gives the first item that passes, as a scan of the list does, while items are removed") {
  test::Random random(7);
  for (const int count : {3, 8, 31, 100}) {
    std::vector<Box2> boxes = random_boxes(count, unsigned(count));
    std::vector<char> removed(boxes.size(), 0);
    BoxTree tree = tree_of(boxes);
    for (int round = 0; round < count; ++round) {
      const Vec2 p(random.real(0, 1), random.real(0, 1));
      const Box2 query{p, p + Vec2(0.1, 0.1)};
      const auto test = [&](const Box2& box) { return box.intersects(query); };
      for (std::size_t from = 0; from <= boxes.size(); ++from) {
        std::size_t expected = from;
        while (expected < boxes.size() && (removed[expected] || !test(boxes[expected]))) ++expected;
        REQUIRE(tree.find(from, test) == (expected < boxes.size() ? expected : BoxTree::kNone));
      }
      const auto gone = std::size_t(random.below(count));
      removed[gone] = 1;
      tree.remove(gone);
    }
  }
}

TEST_CASE("box tree: visit_overlaps gives each overlapping pair once, smaller item first") {
  for (const int count : {2, 5, 16, 77}) {
    const std::vector<Box2> boxes = random_boxes(count, unsigned(count));
    std::set<std::pair<std::size_t, std::size_t>> expected, found;
    for (std::size_t j = 0; j < boxes.size(); ++j) {
      for (std::size_t i = 0; i < j; ++i) {
        if (boxes[i].intersects(boxes[j])) expected.emplace(i, j);
      }
    }
    tree_of(boxes).visit_overlaps([&](std::size_t i, std::size_t j) { REQUIRE(found.emplace(i, j).second); });
    REQUIRE(found == expected);
  }
}

TEST_CASE("box tree: build replaces what the tree held") {
  BoxTree tree = tree_of(random_boxes(50, 1));
  const std::vector<Box2> boxes{box_of({5, 5}, {6, 6})};
  tree.build(1, [&](std::size_t i) { return boxes[i]; });
  CHECK(tree.find(0, [](const Box2& box) { return box.max().x() >= 5; }) == 0);
  CHECK(tree.find(1, [](const Box2&) { return true; }) == BoxTree::kNone);
}

}  // namespace gvd::test_box_tree
