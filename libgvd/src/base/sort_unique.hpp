#pragma once

#include <algorithm>
#include <vector>

namespace gvd {

/// Sorts items, and keeps one of those that are equal. Cost: O(n log n).
template <class Item>
void sort_unique(std::vector<Item>& items) {
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

}  // namespace gvd
