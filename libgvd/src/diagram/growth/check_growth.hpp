#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "diagram/graph/crossings.hpp"
#include "diagram/graph/nearest_labels.hpp"
#include "diagram/growth/grown_gap.hpp"
#include "gvd/mesh.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {

/// Whether a grown gap is consistent; fills in `grown.labels` if it is. It trusts nothing that the growth computed.
///
/// Properties: (1) arcs and nodes fit each other (`check_gap_nodes`); (2) along each edge crossings keep their distance
/// and cells follow each other; (3) the labels of all vertices agree with the crossings (`find_moved_labels`);
/// (4) around branch points the arcs have the order of their cells, and no two cross (`check_gap_arcs`).
/// Source: none; the paper takes the result of growth as it is (section 4.3).
bool check_growth(const WorkingMesh& working, const NearestLabels& labels, const Crossings& crossings, const Gap& gap,
                  GrownGap& grown);

/// An edge of a gap's faces.
struct GapEdge {
  EdgeId edge;
  bool rim;                             ///< whether one of its faces lies outside the gap
  std::span<const Crossing> crossings;  ///< ascending in t
};

/// The edges of a grown gap with their crossings: on the rim, the crossings from before the growth; inside, the
/// crossings that grew.
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

/// Whether the nodes of a grown gap connect its arcs correctly.
///
/// Properties: (1) every crossing of the rim is exactly one node and ends one arc; (2) every new crossing ends one arc
/// in each of its faces; (3) every branch point ends three arcs; (4) each end of an arc lies in the arc's face or on
/// its boundary, a crossing between the arc's two cells. Cost: O(k log k) for k nodes and arcs.
bool check_gap_nodes(const Mesh& mesh, const Crossings& crossings, const Gap& gap, const GapEdges& edges,
                     const GrownGap& grown);

/// The labels of a gap's vertices that follow from its crossings and differ from `labels`, ascending by vertex.
///
/// Vertices on the rim and generators keep their labels; from there labels spread along the gap's edges, and change
/// where an edge is crossed. Nothing if a vertex gets no label, or two edges contradict each other.
/// Cost: O(k log k) for k edges.
std::optional<std::vector<std::pair<VertexId, GeneratorId>>> find_moved_labels(const WorkingMesh& working,
                                                                               const NearestLabels& labels,
                                                                               const GapEdges& gap_edges);

/// Whether the arcs of a grown gap are in general position: around every branch point they follow each other
/// counter-clockwise in the order of their cells, and no two arcs of a face cross. Expects nodes that passed
/// `check_gap_nodes`. Cost: O(k^2) for k arcs.
bool check_gap_arcs(const Mesh& mesh, const Crossings& crossings, const GrownGap& grown);

}  // namespace gvd
