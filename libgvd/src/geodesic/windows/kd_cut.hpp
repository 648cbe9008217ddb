#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "gvd/vec.hpp"

namespace gvd {

/// A list of points cut into boxes with about as many of them in each: the longest side of a box is cut, and again.
/// Points with the same coordinate are told apart by their places in the list.
class KdCut {
 public:
  /// `points` >= 1, of which some thousands are looked at; `boxes` in [1, points].
  KdCut(std::span<const Vec3> points, std::int32_t boxes);

  /// Number of the box of point p, the i-th of the list, in [0, boxes).
  std::int32_t box(const Vec3& p, std::size_t i) const {
    std::int32_t node = root_;
    while (node >= 0) {
      const Node& n = nodes_[static_cast<std::size_t>(node)];
      const double x = p[n.axis];
      node = x < n.split || (x == n.split && i < n.split_place) ? n.below : n.above;
    }
    return ~node;
  }

 private:
  struct Node {
    int axis;
    double split;
    std::size_t split_place;    // of the point at the split
    std::int32_t below, above;  // nodes, or ~boxes
  };

  struct Sample {
    Vec3 point;
    std::size_t place;
  };

  std::int32_t cut(std::span<Sample> samples, std::int32_t first_box, std::int32_t boxes);

  std::vector<Node> nodes_;
  std::int32_t root_;
};

}  // namespace gvd
