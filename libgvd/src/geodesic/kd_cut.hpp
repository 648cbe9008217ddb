#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "gvd/vec.hpp"

namespace gvd {

/// Space cut into boxes with about as many points of a list in each: the longest side of a box is cut, and again.
class KdCut {
 public:
  /// `points` >= 1, of which some thousands are looked at; `boxes` in [1, points].
  KdCut(std::span<const Vec3> points, std::int32_t boxes);

  /// Number of the box that p lies in, in [0, boxes).
  std::int32_t box(const Vec3& p) const {
    std::int32_t node = root_;
    while (node >= 0) {
      const Node& n = nodes_[static_cast<std::size_t>(node)];
      node = p[n.axis] < n.split ? n.below : n.above;
    }
    return ~node;
  }

 private:
  struct Node {
    int axis;
    double split;
    std::int32_t below, above;  // nodes, or ~boxes
  };

  std::int32_t cut(std::span<Vec3> points, std::int32_t first_box, std::int32_t boxes);

  std::vector<Node> nodes_;
  std::int32_t root_;
};

}  // namespace gvd
