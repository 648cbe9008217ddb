#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/bucket_queue.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace gvd::test_bucket_queue {

std::vector<int> pop_all(BucketQueue<int>& queue) {
  std::vector<int> items;
  while (!queue.empty()) items.push_back(queue.pop());
  return items;
}

TEST_CASE("an empty queue is empty, also after use") {
  BucketQueue<int> queue(1, 2);
  CHECK(queue.empty());
  queue.push(0, 7);
  CHECK_FALSE(queue.empty());
  CHECK(queue.pop() == 7);
  CHECK(queue.empty());
}

TEST_CASE("buckets come in the order of their keys, and within one the first comes first") {
  BucketQueue<int> queue(1, 8);
  queue.push(3.5, 1);
  queue.push(0.9, 2);
  queue.push(3.1, 3);
  queue.push(0.1, 4);
  queue.push(6, 5);
  CHECK(pop_all(queue) == std::vector<int>{2, 4, 1, 3, 5});
}

TEST_CASE("a key on the border of two buckets belongs to the later one") {
  BucketQueue<int> queue(0.5, 8);
  queue.push(0.5, 1);
  queue.push(0.49, 2);
  CHECK(pop_all(queue) == std::vector<int>{2, 1});
}

TEST_CASE("a key before the current bucket goes into the current one, behind what is there") {
  BucketQueue<int> queue(1, 8);
  queue.push(5.5, 1);
  queue.push(5.6, 2);
  CHECK(queue.pop() == 1);
  queue.push(0, 3);
  queue.push(6, 4);
  CHECK(pop_all(queue) == std::vector<int>{2, 3, 4});
}

TEST_CASE("keys beyond the ring share its last bucket") {
  BucketQueue<int> queue(1, 4);
  queue.push(100, 1);
  queue.push(std::numeric_limits<double>::infinity(), 2);
  queue.push(50, 3);
  queue.push(2.5, 4);
  queue.push(3.5, 5);
  CHECK(pop_all(queue) == std::vector<int>{4, 1, 2, 3, 5});
}

TEST_CASE("the ring turns: a bucket is used again after it was passed") {
  BucketQueue<int> queue(1, 3);
  std::vector<int> popped;
  queue.push(0, 0);
  for (int i = 0; i < 50; ++i) {
    queue.push(i + 1, i + 1);
    popped.push_back(queue.pop());
  }
  for (int i = 0; i < 50; ++i) CHECK(popped[i] == i);
}

TEST_CASE("random work: everything comes out once, and never a bucket too early") {
  test::Random random(11);
  for (const double width : {1e-12, 0.3, 1e12}) {
    const std::size_t ring = 16;
    BucketQueue<int> queue(width, ring);
    std::vector<double> keys;
    std::vector<int> popped;
    double now = 0;
    const auto push = [&](double key) {
      queue.push(key, static_cast<int>(keys.size()));
      keys.push_back(key);
    };
    for (int i = 0; i < 20; ++i) push(random.real(0, 14) * width);
    for (int i = 0; i < 20000 && !queue.empty(); ++i) {
      popped.push_back(queue.pop());
      const double key = keys[popped.back()];
      REQUIRE(std::floor(key / width) >= std::floor(now / width));
      now = std::max(now, key);
      for (int k = random.below(3); k > 0; --k) push(now + random.real(0, 14) * width);
    }
    const std::vector<int> rest = pop_all(queue);
    popped.insert(popped.end(), rest.begin(), rest.end());
    std::sort(popped.begin(), popped.end());
    REQUIRE(popped.size() == keys.size());
    for (std::size_t i = 0; i < popped.size(); ++i) REQUIRE(popped[i] == static_cast<int>(i));
  }
}

TEST_CASE("empty buckets are passed at once") {
  BucketQueue<int> queue(0.5, 8);
  CHECK(queue.steps_to_next() == 8);
  queue.push(2.6, 1);
  CHECK(queue.steps_to_next() == 5);
  queue.advance(5);
  CHECK(queue.front() == 2.5);
  CHECK(queue.steps_to_next() == 0);
  queue.push(4.1, 2);  // beyond the ring's end, where it begins again
  CHECK(queue.pop() == 1);
  CHECK(queue.steps_to_next() == 3);
  queue.advance(3);
  CHECK(queue.front() == 4);
  CHECK(queue.pop() == 2);
}

TEST_CASE("a queue that has given its memory back goes on from where it was") {
  BucketQueue<int> queue(1.0, 3);
  queue.push(0.5, 1);
  CHECK(queue.pop() == 1);
  queue.release();
  queue.push(0.7, 2);
  queue.push(1.5, 3);
  CHECK(queue.front_size() == 1);
  CHECK(queue.pop() == 2);
  CHECK(queue.pop() == 3);
  CHECK(queue.front() == 1);
  CHECK(queue.empty());
}

TEST_CASE("a key is in front up to the end of the current bucket") {
  BucketQueue<int> queue(0.5, 4);
  CHECK(queue.is_in_front(0.499));
  CHECK_FALSE(queue.is_in_front(0.5));
  queue.push(0.7, 1);
  CHECK(queue.pop() == 1);
  CHECK(queue.is_in_front(0.2));
  CHECK(queue.is_in_front(0.999));
  CHECK_FALSE(queue.is_in_front(1));
}

TEST_CASE("an empty queue can begin again with the bucket of key 0") {
  BucketQueue<int> queue(1.0, 3);
  queue.push(1.5, 1);
  CHECK(queue.pop() == 1);
  queue.restart();
  CHECK(queue.front() == 0);
  queue.push(1.5, 2);
  queue.push(0.5, 3);
  CHECK(queue.pop() == 3);
  CHECK(queue.pop() == 2);
  CHECK(queue.empty());
}

TEST_CASE("one can look at the items that come next in the current bucket, and at no others") {
  BucketQueue<int> queue(1.0, 4);
  CHECK(queue.ahead(0) == nullptr);
  for (const int item : {1, 2, 3}) queue.push(0.5, item);
  queue.push(1.5, 4);
  REQUIRE(queue.ahead(2) != nullptr);
  CHECK(*queue.ahead(0) == 1);
  CHECK(*queue.ahead(2) == 3);
  CHECK(queue.ahead(3) == nullptr);
  CHECK(queue.pop() == 1);
  CHECK(*queue.ahead(1) == 3);
  CHECK(queue.ahead(2) == nullptr);
}

}  // namespace gvd::test_bucket_queue
