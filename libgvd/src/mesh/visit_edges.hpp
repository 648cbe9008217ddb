#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "gvd/ids.hpp"

namespace gvd {

/// The halfedges of one edge, ascending.
class EdgeHalfedges {
 public:
  /// The lower 32 bits of each key are a halfedge.
  explicit EdgeHalfedges(std::span<const std::uint64_t> keys) : keys_(keys) {}

  std::size_t size() const { return keys_.size(); }
  std::int32_t operator[](std::size_t i) const { return std::int32_t(keys_[i] & 0xffffffff); }
  std::vector<std::int32_t> list() const {
    std::vector<std::int32_t> halfedges;
    for (std::size_t i = 0; i < size(); ++i) halfedges.push_back((*this)[i]);
    return halfedges;
  }

 private:
  std::span<const std::uint64_t> keys_;
};

inline std::uint64_t vertex_number(std::int32_t v) { return static_cast<std::uint64_t>(v); }
inline std::uint64_t vertex_number(VertexId v) { return v.index(); }

/// Calls visit(EdgeHalfedges) for each edge of a list of triangles, whatever the direction of its halfedges, sorted by
/// its smaller vertex, then by its larger one. Halfedge 3 f + i runs from corner i of face f to the next corner.
/// Vertices are numbers or ids; the three vertices of a face must differ.
///
/// Sorts by counting on the smaller vertex, and then sorts each short bucket. Cost: O(n) time if degrees are bounded,
/// O(n log n) at worst; temporary memory of 8 bytes a halfedge and 4 bytes a vertex.
template <class Faces, class Visit>
void visit_edges(const Faces& faces, std::size_t vertex_count, const Visit& visit) {
  const auto for_each_halfedge = [&](const auto& take) {
    std::uint64_t h = 0;
    for (const auto& face : faces) {
      const std::uint64_t a = vertex_number(face[0]), b = vertex_number(face[1]), c = vertex_number(face[2]);
      take(a, b, h++);
      take(b, c, h++);
      take(c, a, h++);
    }
  };
  std::vector<std::uint32_t> first(vertex_count + 1, 0);
  for_each_halfedge([&](std::uint64_t a, std::uint64_t b, std::uint64_t) { ++first[std::min(a, b) + 1]; });
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<std::uint64_t> keys(3 * faces.size());
  for_each_halfedge([&](std::uint64_t a, std::uint64_t b, std::uint64_t h) {
    keys[first[std::min(a, b)]++] = std::max(a, b) << 32 | h;
  });
  // Now first[v] is the end of v's bucket.
  std::size_t begin = 0;
  for (std::size_t v = 0; v < vertex_count; ++v) {
    const std::size_t end = first[v];
    std::sort(keys.data() + begin, keys.data() + end);
    while (begin < end) {
      std::size_t next = begin + 1;
      while (next < end && keys[next] >> 32 == keys[begin] >> 32) ++next;
      visit(EdgeHalfedges({keys.data() + begin, next - begin}));
      begin = next;
    }
  }
}

}  // namespace gvd
