#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/repair/work_faces.hpp"

namespace gvd {

/// The halfedges of one edge: `halfedges[begin, end)` of an EdgeTable, ascending.
struct EdgeGroup {
  std::size_t begin, end;
  std::size_t size() const { return end - begin; }
};

/// Edges with their halfedges, whatever the direction of these.
struct EdgeTable {
  std::vector<std::int32_t> halfedges;
  std::vector<EdgeGroup> edges;

  void add(const EdgeHalfedges& edge) {
    edges.push_back({halfedges.size(), halfedges.size() + edge.size()});
    for (std::size_t i = 0; i < edge.size(); ++i) halfedges.push_back(edge[i]);
  }
};

/// Sets `twin` of the two halfedges of each edge with two faces, whatever their direction. Returns the edges of three
/// or more faces, in the order of `visit_edges`. Cost: that of `visit_edges`.
EdgeTable pair_halfedges(WorkFaces& work, std::size_t vertex_count);

}  // namespace gvd
