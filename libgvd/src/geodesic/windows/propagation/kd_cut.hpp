#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "gvd/vec.hpp"

namespace gvd {

/// A list of points cut into boxes of about as many points each, by cutting the longest side of a box repeatedly.
/// Points with the same coordinate are ordered by their index in the list.
class KdCut {
 public:
  /// At least one point; some thousands of them are sampled. `boxes` in [1, number of points].
  KdCut(std::span<const Vec3> points, std::int32_t boxes);

  /// The box, in [0, boxes), of point p, which has the index i in the list.
  std::int32_t box(const Vec3& p, std::size_t i) const {
    std::int32_t node = root_;
    while (node >= 0) {
      const Node& n = nodes_[node];
      const double x = p[n.axis];
      node = x < n.split || (x == n.split && i < n.split_index) ? n.below : n.above;
    }
    return ~node;
  }

 private:
  struct Node {
    int axis;
    double split;
    std::size_t split_index;    // of the point at the split
    std::int32_t below, above;  // nodes, or ~boxes
  };

  struct Sample {
    Vec3 point;
    std::size_t index;
  };

  std::int32_t cut(std::span<Sample> samples, std::int32_t first_box, std::int32_t boxes);

  std::vector<Node> nodes_;
  std::int32_t root_;
};

}  // namespace gvd
