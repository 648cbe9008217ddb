#include "geodesic/windows/propagation/kd_cut.hpp"

#include <algorithm>
#include <tuple>

namespace gvd {
namespace {

/// Number of points that are sampled: the contents of 64 boxes then differ by some tenths.
constexpr std::size_t kSample = 4096;

/// A pseudo-random number in [0, count) that depends on i and count alone. A constant stride would sample every row of
/// a grid in the same column. Source: splitmix64's output function (Steele, Lea and Flood, 2014).
std::size_t scatter(std::uint64_t i, std::size_t count) {
  i = (i ^ (i >> 30)) * 0xbf58476d1ce4e5b9u;
  i = (i ^ (i >> 27)) * 0x94d049bb133111ebu;
  return static_cast<std::size_t>((i ^ (i >> 31)) % count);
}

template <class Samples>
int longest_axis(const Samples& samples) {
  Vec3 low = samples.front().point, high = low;
  for (const auto& s : samples) {
    low = low.cwiseMin(s.point);
    high = high.cwiseMax(s.point);
  }
  Eigen::Index axis = 0;
  (high - low).maxCoeff(&axis);
  return static_cast<int>(axis);
}

}  // namespace

KdCut::KdCut(std::span<const Vec3> points, std::int32_t boxes) {
  std::vector<Sample> samples;
  const std::size_t step = std::max(points.size() / kSample, std::size_t{1});
  for (std::size_t begin = 0; begin < points.size(); begin += step) {
    const std::size_t i = begin + scatter(begin, std::min(step, points.size() - begin));
    samples.push_back({points[i], i});
  }
  root_ = cut(samples, 0, boxes);
}

std::int32_t KdCut::cut(std::span<Sample> samples, std::int32_t first_box, std::int32_t boxes) {
  if (boxes == 1) return ~first_box;
  const int axis = longest_axis(samples);
  const std::int32_t boxes_below = boxes / 2;
  const std::size_t below = samples.size() * static_cast<std::size_t>(boxes_below) / static_cast<std::size_t>(boxes);
  std::nth_element(samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(below), samples.end(),
                   [axis](const Sample& a, const Sample& b) {
                     return std::tuple(a.point[axis], a.index) < std::tuple(b.point[axis], b.index);
                   });
  const Sample& split = samples[below];
  const auto node = static_cast<std::int32_t>(nodes_.size());
  nodes_.push_back({axis, split.point[axis], split.index, 0, 0});
  const std::int32_t lower = cut(samples.first(below), first_box, boxes_below);
  const std::int32_t upper = cut(samples.subspan(below), first_box + boxes_below, boxes - boxes_below);
  nodes_[node].below = lower;
  nodes_[node].above = upper;
  return node;
}

}  // namespace gvd
