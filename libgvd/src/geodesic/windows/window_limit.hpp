#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include "gvd/error.hpp"

namespace gvd {

/// Windows are numbered with 32 bits: four bytes each are saved, and 2^31 of them, kept or waiting, fill 100 GB. A mesh
/// has fewer than 7.2e8 faces, and curved ones keep ten windows a face where all are kept: from 2.1e8 faces on the
/// numbers could end.
inline constexpr std::size_t kMostWindows = std::numeric_limits<std::int32_t>::max();

/// Throws Error{precondition} where there can be no window beside `count` others and the `more` that come with it.
inline void check_window_count(std::size_t count, std::size_t more) {
  if (count <= kMostWindows - more) return;
  throw Error(ErrorCode::precondition,
              "the exact distances on this mesh take more than 2147483647 windows; make it coarser, or use the "
              "distances of fast marching");
}

}  // namespace gvd
