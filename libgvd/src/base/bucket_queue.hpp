#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace gvd {

/// A queue that returns its items in nearly ascending order of their keys: a ring of first-in-first-out buckets.
///
/// It is made for label-correcting propagation, which corrects later what it computed too early. Any other use must
/// tolerate an order that is off by up to one bucket. Items of the same bucket are returned in the order in which they
/// were pushed, so that runs are repeatable. An item whose key lies before the current bucket goes into the current
/// bucket, and one whose key lies beyond the ring into the last bucket. Cost: O(1) per item and per bucket passed.
template <class Item>
class BucketQueue {
 public:
  /// `width` is the span of keys in one bucket, > 0; `count` the number of buckets in the ring, >= 2.
  BucketQueue(double width, std::size_t count) : inverse_width_(1 / width), last_(double(count - 1)), buckets_(count) {}

  bool empty() const { return size_ == 0; }

  /// The least key that belongs to the current bucket. An item in it has a smaller key only if it was pushed after the
  /// bucket of that key had passed.
  double front() const { return turn_ / inverse_width_; }

  void push(double key, const Item& item) {
    const double ahead = key * inverse_width_ - turn_;
    // The cast rounds down; a negative value means the current bucket.
    const std::size_t offset = ahead > 0 ? static_cast<std::size_t>(std::min(ahead, last_)) : 0;
    buckets_[wrapped(current_ + offset)].push_back(item);
    ++size_;
  }

  /// Whether an item with this key belongs to the current bucket or to one before it.
  bool is_in_front(double key) const { return !(key * inverse_width_ - turn_ >= 1); }

  /// Number of items in the current bucket.
  std::size_t front_size() const { return buckets_[current_].size() - next_; }

  /// The item that pop() will return after `count` others; null if that item is not in the current bucket.
  const Item* ahead(std::size_t count) const {
    return count < front_size() ? &buckets_[current_][next_ + count] : nullptr;
  }

  /// How many buckets ahead the next item is: 0 if it is in the current bucket, the size of the ring if the queue is
  /// empty. Cost: O(1) per bucket in between.
  std::size_t steps_to_next() const {
    if (empty()) return buckets_.size();
    if (front_size() > 0) return 0;
    std::size_t steps = 1;
    while (buckets_[wrapped(current_ + steps)].empty()) ++steps;
    return steps;
  }
  /// Advances by `steps` buckets. The current bucket, and the buckets that are skipped, must be empty.
  void advance(std::size_t steps = 1) {
    buckets_[current_].clear();
    next_ = 0;
    current_ = wrapped(current_ + steps);
    turn_ += double(steps);
  }

  /// The next item. The queue must not be empty.
  Item pop() {
    while (front_size() == 0) advance();
    --size_;
    return buckets_[current_][next_++];
  }

  /// Number of buckets in the ring.
  std::size_t bucket_count() const { return buckets_.size(); }

  /// Starts over with the bucket of key 0. The queue must be empty.
  void restart() {
    buckets_[current_].clear();
    next_ = 0;
    current_ = 0;
    turn_ = 0;
  }

  /// Frees the buckets' memory. The queue must be empty.
  void release() {
    for (std::vector<Item>& bucket : buckets_) bucket = std::vector<Item>();
    next_ = 0;
  }

 private:
  /// Wraps an index, which must be less than twice the size of the ring.
  std::size_t wrapped(std::size_t index) const { return index < buckets_.size() ? index : index - buckets_.size(); }

  double inverse_width_;
  double last_;  // number of the ring's last bucket, counted from the current one
  std::vector<std::vector<Item>> buckets_;
  std::size_t current_ = 0;  // bucket at the front of the ring
  std::size_t next_ = 0;     // next item in it
  double turn_ = 0;          // number of buckets passed since the start: a whole number
  std::size_t size_ = 0;
};

}  // namespace gvd
