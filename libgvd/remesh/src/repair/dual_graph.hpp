#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "gvd/ids.hpp"

namespace gvd {

/// The dual graph of some faces: a node for each face, a link for each edge that the graph may cross.
class DualGraph {
 public:
  /// The node beyond the border of the faces.
  static constexpr std::int32_t kOutside = -1;

  explicit DualGraph(std::size_t faces) : links_of_(faces) {}

  /// Links two nodes across the edge of a halfedge.
  void add_link(HalfedgeId crossed, std::int32_t from, std::int32_t to);

  /// Removes faces with a single link, and that link, until there are none. The outside is never removed. Returns the
  /// halfedges of the links that remain, in the order of add_link: those on cycles or on paths between two cycles or
  /// borders. Cost: O(faces and links).
  std::vector<HalfedgeId> prune_leaves() const;

 private:
  struct Link {
    HalfedgeId crossed;
    std::array<std::int32_t, 2> nodes;
  };
  std::vector<Link> links_;
  std::vector<std::vector<std::int32_t>> links_of_;  // of every face
};

}  // namespace gvd
