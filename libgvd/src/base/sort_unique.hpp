#pragma once

#include <algorithm>
#include <vector>

namespace gvd {

/// Sorts items and removes duplicates. Cost: O(n log n).
template <class Item>
void sort_unique(std::vector<Item>& items) {
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

}  // namespace gvd
