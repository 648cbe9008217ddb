// Packs boxes on the shelves of a square.
#include "pack_boxes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "gvd/charts.hpp"

namespace gvd {
namespace {

/// Fills shelves from below. Returns the lower left corners of the boxes, or nothing if they do not fit.
std::vector<Vec2> fill_shelves(const std::vector<Vec2>& sizes, const std::vector<std::size_t>& order, double side,
                               double margin) {
  std::vector<Vec2> at(sizes.size());
  double x = 0, y = 0, height = 0;
  for (const std::size_t i : order) {
    const Vec2 size = sizes[i] + Vec2(2 * margin, 2 * margin);
    if (x > 0 && x + size.x() > side) {
      x = 0;
      y += std::exchange(height, 0);
    }
    if (x + size.x() > side || y + size.y() > side) return {};
    at[i] = Vec2(x + margin, y + margin);
    x += size.x();
    height = std::max(height, size.y());
  }
  return at;
}

}  // namespace

Packing pack_boxes(const std::vector<Vec2>& sizes) {
  constexpr double kGrowth = 1.01, kMarginOfMeanSide = 1.0 / 8;
  std::vector<std::size_t> order(sizes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return sizes[a].y() > sizes[b].y(); });
  double area = 0, longest = 0;
  for (const Vec2& size : sizes) area += size.prod(), longest = std::max(longest, size.maxCoeff());
  const double margin =
      std::min(kChartMargin, kMarginOfMeanSide / std::sqrt(double(std::max<std::size_t>(1, sizes.size()))));
  Packing packing;
  if (!(longest > 0)) return {std::vector<Vec2>(sizes.size(), Vec2::Zero()), 0};
  for (packing.side = std::max(longest, std::sqrt(area)); packing.at.empty(); packing.side *= kGrowth) {
    packing.at = fill_shelves(sizes, order, packing.side, margin * packing.side);
    if (!packing.at.empty()) break;
  }
  return packing;
}

}  // namespace gvd
