#pragma once

#include <map>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// A part of an edge that belongs to one cell, as one of the edge's faces has it.
struct EdgeLabel {
  double begin = 0;  ///< parameter along the edge's halfedge `mesh.halfedge(edge)`
  double end = 1;
  GeneratorId cell;
};

/// Labels of whole edges, out of the labels and the pieces of their faces.
class EdgeLabels {
 public:
  /// Both must outlive this. Cost: O(pieces).
  EdgeLabels(const Mesh& mesh, const Diagram& diagram);

  /// The parts that all faces of the edge have, in no order. The two faces of an inner edge agree, unless a bisector
  /// runs along it. Empty where no generator reaches it. Cost: O(corners of the faces' pieces).
  std::vector<EdgeLabel> of(EdgeId edge) const;

 private:
  void append(HalfedgeId h, bool forwards, std::vector<EdgeLabel>& labels) const;

  const Mesh& mesh_;
  const Diagram& diagram_;
  std::map<FaceId, std::size_t> first_piece_;  // of each cut face
};

}  // namespace gvd
