#pragma once

#include <cstdint>
#include <numeric>
#include <vector>

namespace gvd {

/// Disjoint sets of the numbers 0 .. n - 1 (union-find with path halving). The smallest member represents its set.
/// Cost: O(log n) amortised for each operation.
class UnionFind {
 public:
  explicit UnionFind(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }

  /// Adds a set with one new member, and returns the member.
  std::int32_t add() {
    parent_.push_back(static_cast<std::int32_t>(parent_.size()));
    return parent_.back();
  }
  /// The smallest member of the set of i.
  std::int32_t find(std::int32_t i) {
    while (parent(i) != i) i = parent(i) = parent(parent(i));
    return i;
  }
  /// Joins the set of i and the set of j.
  void unite(std::int32_t i, std::int32_t j) {
    i = find(i);
    j = find(j);
    if (i < j) parent(j) = i;
    if (j < i) parent(i) = j;
  }
  /// The number of members of all sets together.
  std::size_t size() const { return parent_.size(); }

 private:
  std::int32_t& parent(std::int32_t i) { return parent_[i]; }
  std::vector<std::int32_t> parent_;
};

}  // namespace gvd
