#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "diagram/graph/crossings.hpp"
#include "diagram/growth/growth.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// An edge of a gap's faces.
struct GapEdge {
  EdgeId edge;
  bool rim;                             ///< one of its faces lies outside the gap
  std::span<const Crossing> crossings;  ///< ascending in t
};

/// The edges of a grown gap with their crossings: on the rim those from before the growth, inside those that grew.
/// Cost: O(k log k) for k faces and crossings.
class GapEdges {
 public:
  GapEdges(const Mesh& mesh, const Crossings& crossings, const Gap& gap, const GrownGap& grown);
  GapEdges(const GapEdges&) = delete;  // the edges refer to its own crossings
  GapEdges& operator=(const GapEdges&) = delete;

  /// Ascending by edge.
  const std::vector<GapEdge>& edges() const { return edges_; }
  std::size_t rim_crossing_count() const;
  /// Whether crossings keep kCrossingGap from each other and from the ends of their edge, and cells follow each other
  /// along it.
  bool are_consistent() const;

 private:
  void collect_edges(const Mesh& mesh, const Gap& gap);
  void collect_crossings(const Crossings& crossings, const GrownGap& grown);

  std::vector<GapEdge> edges_;
  std::vector<Crossing> crossings_;  // of all edges, ascending by (edge, t)
};

}  // namespace gvd
