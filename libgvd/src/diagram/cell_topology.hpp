#pragma once

#include <vector>

#include "diagram/diagram_graph.hpp"
#include "diagram/union_find.hpp"

namespace gvd {

/// The parts that the bisectors cut the faces into, and how they hang together in cells. A part is a whole face or a
/// piece of one. Cost: O(n) time and memory.
class CellParts {
 public:
  CellParts(const WorkingMesh& working, const TracedDiagram& traced);

  /// Components of every cell: 1 where it is connected.
  IdVector<GeneratorId, std::int32_t> count_components();

  /// All edges of the faces that hold a component without its own generator's vertex. Empty in a sound diagram.
  std::vector<EdgeId> island_edges();

 private:
  static constexpr std::int32_t kWhole = -1;

  void cut(FaceId f, std::size_t first_arc, std::size_t last_arc);
  void join_across(EdgeId e);
  /// The part that touches run `run` of halfedge h, counted along h.
  std::int32_t part(HalfedgeId h, std::int32_t run) const;

  const WorkingMesh& working_;
  const Mesh& mesh_;
  const TracedDiagram& traced_;
  UnionFind sets_;                               // parts 0 .. faces - 1 are the faces, then come the pieces
  std::vector<FaceId> part_face_;                // of the pieces
  std::vector<GeneratorId> part_label_;          // of all parts; invalid where a face is cut or nothing reaches it
  IdVector<FaceId, std::int32_t> cut_index_;     // place in run_parts_ / 3, or kWhole
  std::vector<std::vector<std::int32_t>> run_parts_;  // three for every cut face: the part at each run of the halfedge
};

/// Loops of bisectors and of the mesh's boundary round every cell. Cost: O(k) for k arcs and boundary edges.
IdVector<GeneratorId, std::int32_t> count_boundary_loops(const WorkingMesh& working, const TracedDiagram& traced);

}  // namespace gvd
