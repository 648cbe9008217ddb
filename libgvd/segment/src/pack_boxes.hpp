#pragma once

#include <vector>

#include "gvd/vec.hpp"

namespace gvd {

/// Boxes in a square.
struct Packing {
  std::vector<Vec2> at;  ///< their lower left corners
  double side = 0;       ///< of the square
};

/// Puts boxes of these sizes on shelves, the highest first, with free space round each (kChartMargin). Sides of the
/// square are tried in steps of 1 %, and the first that holds all is taken. Ties keep the order. Cost: O(n log n) for
/// each side.
Packing pack_boxes(const std::vector<Vec2>& sizes);

}  // namespace gvd
