#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include "gvd/error.hpp"

namespace gvd {

/// Windows are numbered with 32 bits, which saves four bytes each; 2^31 of them, kept or waiting, fill 100 GB. Curved
/// meshes keep about ten windows a face if all are kept, so the numbers could run out from 2.1e8 faces on. (A mesh has
/// fewer than 7.2e8 faces.)
inline constexpr std::size_t kMostWindows = std::numeric_limits<std::int32_t>::max();

/// Throws Error{precondition} if `count` windows and `more` of them are too many.
inline void check_window_count(std::size_t count, std::size_t more) {
  if (count <= kMostWindows - more) return;
  throw Error(ErrorCode::precondition,
              "the exact distances on this mesh take more than 2147483647 windows; make it coarser, or use the "
              "distances of fast marching");
}

}  // namespace gvd
