// Groups halfedges by edge.
#include <algorithm>
#include <numeric>
#include <tuple>

#include "mesh/repair_soup.hpp"

namespace gvd {

// A counting sort on the smaller vertex, then a short sort within each bucket.
EdgeTable group_edges(const WorkFaces& work, std::size_t vertex_count) {
  const std::int32_t n = work.halfedge_count();
  const auto low = [&](std::int32_t h) { return std::min(work.from(h), work.to(h)); };
  const auto high = [&](std::int32_t h) { return std::max(work.from(h), work.to(h)); };
  std::vector<std::int32_t> first(vertex_count + 1, 0);
  for (std::int32_t h = 0; h < n; ++h) ++first[static_cast<std::size_t>(low(h)) + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  EdgeTable table;
  table.halfedges.resize(static_cast<std::size_t>(n));
  std::vector<std::int32_t> cursor(first.begin(), first.end() - 1);
  for (std::int32_t h = 0; h < n; ++h) {
    table.halfedges[static_cast<std::size_t>(cursor[static_cast<std::size_t>(low(h))]++)] = h;
  }
  table.edges.reserve(static_cast<std::size_t>(n) / 2);
  const auto& halfedges = table.halfedges;
  for (std::size_t v = 0; v < vertex_count; ++v) {
    const auto begin = static_cast<std::size_t>(first[v]);
    const auto end = static_cast<std::size_t>(first[v + 1]);
    std::sort(table.halfedges.begin() + first[v], table.halfedges.begin() + first[v + 1],
              [&](std::int32_t a, std::int32_t b) { return std::pair(high(a), a) < std::pair(high(b), b); });
    for (std::size_t i = begin; i < end;) {
      std::size_t j = i + 1;
      while (j < end && high(halfedges[j]) == high(halfedges[i])) ++j;
      table.edges.push_back({i, j});
      i = j;
    }
  }
  return table;
}

}  // namespace gvd
