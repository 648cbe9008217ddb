#include "base/corner_boxes.hpp"

#include <bit>
#include <limits>

namespace gvd {

CornerBoxes::CornerBoxes(const std::vector<Vec2>& corners)
    : leaves_(std::bit_ceil(corners.size())), boxes_(2 * leaves_, empty_box()) {
  for (std::size_t i = 0; i < corners.size(); ++i) boxes_[leaves_ + i] = {corners[i], corners[i]};
  for (std::size_t node = leaves_; node-- > 1;) unite_children(node);
}

void CornerBoxes::remove(std::size_t corner) {
  std::size_t node = leaves_ + corner;
  boxes_[node] = empty_box();
  while ((node /= 2) > 0) unite_children(node);
}

CornerBoxes::Box CornerBoxes::empty_box() {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  return {Vec2::Constant(kInfinity), Vec2::Constant(-kInfinity)};
}

void CornerBoxes::unite_children(std::size_t node) {
  const Box &left = boxes_[2 * node], &right = boxes_[2 * node + 1];
  boxes_[node] = {left.low.cwiseMin(right.low), left.high.cwiseMax(right.high)};
}

}  // namespace gvd
