#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "geodesic/window.hpp"

namespace gvd {

/// Windows in blocks that never move, and a list of those that are free again: the last one freed is the next one used,
/// while the cache still holds it.
class WindowPool {
 public:
  Window& operator[](std::int32_t i) { return blocks_[static_cast<std::size_t>(i) >> kShift][i & kMask]; }
  const Window& operator[](std::int32_t i) const { return blocks_[static_cast<std::size_t>(i) >> kShift][i & kMask]; }

  /// A window to fill in.
  std::int32_t take() {
    if (free_ >= 0) {
      const std::int32_t place = free_;
      free_ = (*this)[place].next;
      return place;
    }
    if ((used_ & kMask) == 0) blocks_.push_back(std::make_unique_for_overwrite<Window[]>(kMask + 1));
    return used_++;
  }
  void free(std::int32_t place) {

    (*this)[place].next = free_;
    free_ = place;
  }
  /// Memory of all blocks.
  std::int64_t bytes() const { return static_cast<std::int64_t>(blocks_.size()) * (kMask + 1) * static_cast<std::int64_t>(sizeof(Window)); }

 private:
  static constexpr int kShift = 10;
  static constexpr std::int32_t kMask = (1 << kShift) - 1;

  std::vector<std::unique_ptr<Window[]>> blocks_;
  std::int32_t used_ = 0, free_ = -1;

};

}  // namespace gvd
