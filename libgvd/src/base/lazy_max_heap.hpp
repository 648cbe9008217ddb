#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace gvd {

/// A max-heap for keys that only decrease. The heap updates a key when its item reaches the top.
///
/// The stored key of an item is an upper bound of its current key, so the first top item whose key is up to date is the
/// largest of all. Among equal keys the smallest id comes first. `Value` is the type of the keys. Cost: O(log n) for
/// each outdated key that reaches the top.
template <class Value = double>
class LazyMaxHeap {
 public:
  struct Item {
    Value key;
    std::int32_t id;
    bool operator<(const Item& other) const { return key < other.key || (key == other.key && id > other.id); }
  };

  /// Inserts the ids 0 .. count - 1. `key(id)` returns the current key of an item.
  template <class Key>
  LazyMaxHeap(std::int32_t count, Key key) {
    items_.reserve(count);
    for (std::int32_t id = 0; id < count; ++id) items_.push_back({key(id), id});
    std::make_heap(items_.begin(), items_.end());
  }

  bool empty() const { return items_.empty(); }

  /// The item with the largest key. The heap must not be empty.
  template <class Key>
  const Item& top(Key key) {
    for (;;) {
      const Item item = items_.front();
      const Value now = key(item.id);
      if (!(now < item.key)) return items_.front();
      lower_top(now);
    }
  }

  void pop() {
    std::pop_heap(items_.begin(), items_.end());
    items_.pop_back();
  }

 private:
  /// Gives the top item a smaller key, and lets it sink to its place.
  void lower_top(const Value& key) {
    const Item item{key, items_.front().id};
    std::size_t at = 0;
    for (std::size_t child = 1; child < items_.size(); child = 2 * at + 1) {
      if (child + 1 < items_.size() && items_[child] < items_[child + 1]) ++child;
      if (!(item < items_[child])) break;
      items_[at] = items_[child];
      at = child;
    }
    items_[at] = item;
  }

  std::vector<Item> items_;
};

}  // namespace gvd
