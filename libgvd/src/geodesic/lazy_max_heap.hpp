#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace gvd {

/// The largest of many keys that only ever fall: a heap that learns of a fall when the item comes to its top.
///
/// An item's key in the heap is an upper bound, so the first top whose key is true is the largest of all. Among equal
/// keys the least id comes first. Cost: O(log n) for each outdated key that comes up.
class LazyMaxHeap {
 public:
  struct Item {
    double key;
    std::int32_t id;
    bool operator<(const Item& other) const { return key < other.key || (key == other.key && id > other.id); }
  };

  explicit LazyMaxHeap(std::vector<Item> items) : items_(std::move(items)) {
    std::make_heap(items_.begin(), items_.end());
  }

  bool empty() const { return items_.empty(); }

  /// Takes the item with the largest key out. `key(id)` gives the true one. The heap must not be empty.
  template <class Key>
  Item pop(Key key) {
    for (;;) {
      std::pop_heap(items_.begin(), items_.end());
      const double now = key(items_.back().id);
      if (!(now < items_.back().key)) break;
      items_.back().key = now;
      std::push_heap(items_.begin(), items_.end());
    }
    const Item top = items_.back();
    items_.pop_back();
    return top;
  }

 private:
  std::vector<Item> items_;
};

}  // namespace gvd
