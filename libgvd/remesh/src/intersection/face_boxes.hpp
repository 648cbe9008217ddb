#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "gvd/mesh.hpp"

namespace gvd {

/// A box whose sides are parallel to the axes, mesh units.
struct Box3 {
  Vec3 low, high;
};

/// The bounding box of a face, without rounding.
Box3 face_box(const Mesh& mesh, FaceId f);

/// Whether two closed boxes have a common point.
inline bool overlap(const Box3& a, const Box3& b) {
  return (a.low.array() <= b.high.array()).all() && (b.low.array() <= a.high.array()).all();
}

/// A balanced tree of the bounding boxes of faces, split at the median of the longest axis.
class FaceBoxes {
 public:
  /// Of all faces. Cost: O(n log n).
  explicit FaceBoxes(const Mesh& mesh);
  /// Of these faces, each listed once. Cost: O(n), and O(k log k) for k of them.
  FaceBoxes(const Mesh& mesh, std::vector<FaceId> faces);

  /// Calls visit(f) for every face whose box overlaps this one. Cost: O(log n) and O(1) a visit, as a rule.
  template <class Visit>
  void visit(const Box3& box, const Visit& visit) const {
    any_of(box, [&visit](FaceId f) {
      visit(f);
      return false;
    });
  }

  /// Whether holds(f) is true of a face whose box overlaps this one; the first one ends the search.
  template <class Holds>
  bool any_of(const Box3& box, const Holds& holds) const {
    return !nodes_.empty() && any_below(0, box, holds);
  }

 private:
  static constexpr std::int32_t kLeafFaces = 4;
  struct Node {
    Box3 box;
    std::int32_t first = 0, count = 0;  ///< into faces_
    std::int32_t right = -1;            ///< second child; the first one follows its parent; -1 in a leaf
  };

  void build(std::int32_t first, std::int32_t count);

  template <class Holds>
  bool any_below(std::int32_t index, const Box3& box, const Holds& holds) const {
    const Node& node = nodes_[index];
    if (!overlap(node.box, box)) return false;
    if (node.right >= 0) return any_below(index + 1, box, holds) || any_below(node.right, box, holds);
    for (std::int32_t i = node.first; i < node.first + node.count; ++i) {
      const FaceId f = faces_[i];
      if (overlap(boxes_[f], box) && holds(f)) return true;
    }
    return false;
  }

  IdVector<FaceId, Box3> boxes_;  // of all faces of the mesh
  std::vector<FaceId> faces_;
  std::vector<Node> nodes_;
};

}  // namespace gvd
