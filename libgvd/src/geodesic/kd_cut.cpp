#include "geodesic/kd_cut.hpp"

#include <algorithm>

namespace gvd {
namespace {

/// Points that are looked at: the contents of 64 boxes then differ by some tenths.
constexpr std::size_t kSample = 4096;

int longest_axis(std::span<const Vec3> points) {
  Vec3 low = points.front(), high = low;
  for (const Vec3& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  Eigen::Index axis = 0;
  (high - low).maxCoeff(&axis);
  return static_cast<int>(axis);
}

}  // namespace

KdCut::KdCut(std::span<const Vec3> points, std::int32_t boxes) {
  std::vector<Vec3> sample;
  const std::size_t step = std::max(points.size() / kSample, std::size_t{1});
  for (std::size_t i = 0; i < points.size(); i += step) sample.push_back(points[i]);
  root_ = cut(sample, 0, boxes);
}

std::int32_t KdCut::cut(std::span<Vec3> points, std::int32_t first_box, std::int32_t boxes) {
  if (boxes == 1) return ~first_box;
  const int axis = longest_axis(points);
  const std::int32_t boxes_below = boxes / 2;
  const std::size_t below = points.size() * static_cast<std::size_t>(boxes_below) / static_cast<std::size_t>(boxes);
  std::nth_element(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(below), points.end(),
                   [axis](const Vec3& a, const Vec3& b) { return a[axis] < b[axis]; });
  const double split = points[below][axis];
  const auto node = static_cast<std::int32_t>(nodes_.size());
  nodes_.push_back({axis, split, 0, 0});
  const std::int32_t lower = cut(points.first(below), first_box, boxes_below);
  const std::int32_t upper = cut(points.subspan(below), first_box + boxes_below, boxes - boxes_below);
  nodes_[static_cast<std::size_t>(node)].below = lower;
  nodes_[static_cast<std::size_t>(node)].above = upper;
  return node;
}

}  // namespace gvd
