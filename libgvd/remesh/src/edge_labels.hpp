#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "diagram/cell_parts.hpp"
#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// A part of an edge or of a curve that belongs to one cell, as seen from one of the faces there.
struct LabelInterval {
  double begin = 0;  ///< parameter along the edge's halfedge `mesh.halfedge(edge)`, or length along the curve
  double end = 1;
  GeneratorId cell;
};

/// The label intervals of a whole edge, from all faces of the edge, in no particular order. They are the sides of the
/// cells' parts of these faces whose two ends have a 0 for the corner opposite the edge.
///
/// The two faces of an inner edge agree, unless a bisector runs along it. Empty if no generator reaches the edge. Cost:
/// O(log p) for p pieces of the diagram, and O(corners of the faces' parts).
inline std::vector<LabelInterval> label_edge(const Mesh& mesh, const Diagram& diagram, EdgeId edge) {
  std::vector<LabelInterval> labels;
  const HalfedgeId first = mesh.halfedge(edge);
  for (const HalfedgeId h : {first, mesh.twin(first)}) {
    if (!h.valid()) continue;
    const int to = Mesh::corner(Mesh::next(h)), opposite = Mesh::corner(Mesh::previous(h));
    const auto along = [&](const Bary& bary) { return h == first ? bary[to] : 1 - bary[to]; };
    for_each_cell_part(diagram, Mesh::face(h), [&](const FacePart& part) {
      for (std::size_t k = 0; k < part.corners.size(); ++k) {
        const Bary &a = part.corners[k], &b = part.corners[(k + 1) % part.corners.size()];
        if (a[opposite] != 0 || b[opposite] != 0) continue;
        labels.push_back({std::min(along(a), along(b)), std::max(along(a), along(b)), part.generator});
      }
    });
  }
  return labels;
}

}  // namespace gvd
