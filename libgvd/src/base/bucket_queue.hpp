#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace gvd {

/// A queue that gives its items back in nearly ascending order of their keys: a ring of first-in-first-out buckets.
///
/// For label-correcting propagation, whose result does not depend on the order. Items within one bucket come out in the
/// order in which they went in, so runs repeat exactly. A key before the current bucket goes into the current one, a
/// key beyond the ring into its last. Cost: O(1) an item, and O(1) for every bucket that is passed.
template <class Item>
class BucketQueue {
 public:
  /// `width` is the span of keys in one bucket, > 0; `count` the number of buckets in the ring, >= 2.
  BucketQueue(double width, std::size_t count)
      : inverse_width_(1 / width), last_(static_cast<double>(count - 1)), buckets_(count) {}

  bool empty() const { return size_ == 0; }

  /// No item has a key below this, but those that were pushed with a key below it.
  double front() const { return static_cast<double>(turn_) / inverse_width_; }

  void push(double key, const Item& item) {
    const double ahead = key * inverse_width_ - turn_;
    // A cast cuts off the fraction; below 0 everything goes into the current bucket.
    const std::size_t offset = ahead > 0 ? static_cast<std::size_t>(std::min(ahead, last_)) : 0;
    buckets_[wrapped(current_ + offset)].push_back(item);
    ++size_;
  }

  /// Number of items in the current bucket.
  std::size_t front_size() const { return buckets_[current_].size() - next_; }

  /// The item that pop() will return after `count` others; null where the current bucket holds fewer.
  const Item* ahead(std::size_t count) const {
    return count < front_size() ? &buckets_[current_][next_ + count] : nullptr;
  }

  /// Number of buckets from the current one to the first one that holds items: 0 where that is the current one, the
  /// ring's size where there is none. Cost: O(1) for every bucket between.
  std::size_t steps_to_next() const {
    if (empty()) return buckets_.size();
    if (front_size() > 0) return 0;
    std::size_t steps = 1;
    while (buckets_[wrapped(current_ + steps)].empty()) ++steps;
    return steps;
  }
  /// Goes on by so many buckets. The current one, and those that are passed, must be empty.
  void advance(std::size_t steps = 1) {
    buckets_[current_].clear();
    next_ = 0;
    current_ = wrapped(current_ + steps);
    turn_ += static_cast<double>(steps);
  }

  /// The next item. The queue must not be empty.
  Item pop() {
    while (front_size() == 0) advance();
    --size_;
    return buckets_[current_][next_++];
  }

  /// Number of buckets in the ring.
  std::size_t bucket_count() const { return buckets_.size(); }

  /// Gives the buckets' memory back. The queue must be empty.
  void release() {
    for (std::vector<Item>& bucket : buckets_) bucket = std::vector<Item>();
    next_ = 0;
  }

 private:
  /// `place` < twice the size of the ring.
  std::size_t wrapped(std::size_t place) const { return place < buckets_.size() ? place : place - buckets_.size(); }

  double inverse_width_;
  double last_;  // number of the ring's last bucket, counted from the current one
  std::vector<std::vector<Item>> buckets_;
  std::size_t current_ = 0;  // bucket at the front of the ring
  std::size_t next_ = 0;     // next item in it
  double turn_ = 0;          // number of buckets passed since the start: a whole number
  std::size_t size_ = 0;
};

}  // namespace gvd
