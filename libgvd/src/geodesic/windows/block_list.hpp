#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "base/prefetch.hpp"
#include "gvd/error.hpp"

namespace gvd {

/// The largest number of windows. They are numbered with 32 bits, which saves four bytes each; 2^31 windows, kept or
/// waiting, fill 100 GB. Curved meshes keep about ten windows a face if all are kept, so the numbers could run out from
/// 2.1e8 faces on. (A mesh has fewer than 7.2e8 faces.)
inline constexpr std::size_t kMostWindows = std::numeric_limits<std::int32_t>::max();

/// Throws Error{precondition} if `count` windows and `more` of them are too many.
inline void check_window_count(std::size_t count, std::size_t more) {
  if (count <= kMostWindows - more) return;
  throw Error(ErrorCode::precondition,
              "exact distances on this mesh need more than 2147483647 windows; make the mesh coarser, or use the "
              "distances of fast marching");
}

/// A sequence that grows without moving its items, up to kMostWindows.
template <class T>
class BlockList {
 public:
  void push_back(const T& value) {
    if (size_ == blocks_.size() * kBlock) add_block();
    blocks_[size_ / kBlock][size_ % kBlock] = value;
    ++size_;
  }
  /// Appends the blocks of another list, and returns the index of its first item. The indices between the former last
  /// item and that one hold nothing.
  std::size_t append(BlockList other) {
    const std::size_t first = blocks_.size() * kBlock;
    for (auto& block : other.blocks_) blocks_.push_back(std::move(block));
    check_window_count(first, other.size_);
    size_ = first + other.size_;
    return first;
  }
  std::size_t size() const { return size_; }
  const T& operator[](std::size_t i) const { return blocks_[i / kBlock][i % kBlock]; }

 private:
  void add_block() {
    check_window_count(size_, kBlock);
    blocks_.push_back(std::make_unique_for_overwrite<T[]>(kBlock));
  }

  static constexpr std::size_t kBlock = 256;
  std::vector<std::unique_ptr<T[]>> blocks_;
  std::size_t size_ = 0;
};

/// A first-in-first-out queue that releases its items block by block and reuses their memory.
template <class T>
class BlockQueue {
 public:
  static constexpr std::size_t kBlock = 256;

  bool empty() const { return blocks_.empty(); }
  std::size_t block_count() const { return blocks_.size(); }

  /// Appends an item, and returns whether the last block was full before. It is always inlined, because it belongs to
  /// the innermost loop.
  [[gnu::always_inline]] bool push_back(const T& value) {
    const bool full = end_ == kBlock;
    if (full || blocks_.empty()) [[unlikely]]
      add_block();
    last_[end_++] = value;
    return full;
  }
  /// Removes the oldest block and calls visit(std::span<const T>) with its items; `visit` may add items.
  template <class Visit>
  void take_block(Visit visit) {
    std::unique_ptr<T[]> block = std::move(blocks_.front());
    const std::size_t count = blocks_.size() == 1 ? end_ : kBlock;
    blocks_.pop_front();
    visit(std::span<const T>(block.get(), count));
    if (spare_.size() < kSpare) spare_.push_back(std::move(block));
  }

 private:
  /// Number of empty blocks that are kept for reuse. More would take memory that other queues need.
  static constexpr std::size_t kSpare = 2;

  [[gnu::noinline]] void add_block() {
    if (spare_.empty()) spare_.push_back(std::make_unique_for_overwrite<T[]>(kBlock));
    blocks_.push_back(std::move(spare_.back()));
    spare_.pop_back();
    last_ = blocks_.back().get();
    end_ = 0;
  }

  std::deque<std::unique_ptr<T[]>> blocks_;
  std::vector<std::unique_ptr<T[]>> spare_;
  T* last_ = nullptr;    // the last block
  std::size_t end_ = 0;  // number of items in it
};

}  // namespace gvd
