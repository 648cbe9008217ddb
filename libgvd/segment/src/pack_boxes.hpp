#pragma once

#include <vector>

#include "gvd/vec.hpp"

namespace gvd {

/// Boxes packed in a square.
struct Packing {
  std::vector<Vec2> at;  ///< lower left corners of the boxes
  double side = 0;       ///< of the square
};

/// Packs boxes of these sizes on shelves, the highest first, with free space around each (kChartMargin). Tries sides of
/// the square in steps of 1 %, and takes the first that holds all boxes. Boxes of equal height keep their order. Cost:
/// O(n log n), and O(n) for each side tried.
Packing pack_boxes(const std::vector<Vec2>& sizes);

}  // namespace gvd
