// An order of points for trees of boxes: halves, by the median along the longest side of their box.
#include "dual/order_in_space.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "dual/placed_faces.hpp"

namespace gvd {
namespace {

void order_by_halves(const std::vector<Vec3>& points, std::vector<std::int32_t>::iterator begin,
                     std::vector<std::int32_t>::iterator end) {
  if (end - begin < 3) return;
  Box3 all;
  for (auto it = begin; it != end; ++it) all.extend(points[*it]);
  Eigen::Index axis = 0;
  all.sizes().maxCoeff(&axis);
  const auto middle = begin + (end - begin) / 2;
  std::nth_element(begin, middle, end, [&](std::int32_t p, std::int32_t q) {
    return std::pair(points[p][axis], p) < std::pair(points[q][axis], q);
  });
  order_by_halves(points, begin, middle);
  order_by_halves(points, middle, end);
}

}  // namespace

std::vector<std::int32_t> order_in_space(const std::vector<Vec3>& points) {
  std::vector<std::int32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  order_by_halves(points, order.begin(), order.end());
  return order;
}

}  // namespace gvd
