#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// A part of an edge or of a curve that belongs to one cell, as one of the faces there has it.
struct LabelInterval {
  double begin = 0;  ///< parameter along the edge's halfedge `mesh.halfedge(edge)`, or length along the curve
  double end = 1;
  GeneratorId cell;
};

/// Label intervals of whole edges, out of the labels and the pieces of their faces.
///
/// A face that lies in one cell gives its label to its whole edges. A face that is cut into pieces has the label
/// intervals of its edges in the sides of its pieces: those whose two ends have a 0 for the corner opposite to the
/// edge.
class EdgeLabels {
 public:
  /// Both must outlive this. Cost: O(pieces).
  EdgeLabels(const Mesh& mesh, const Diagram& diagram) : mesh_(mesh), diagram_(diagram) {
    for (std::size_t i = 0; i < diagram.pieces.size(); ++i) first_piece_.try_emplace(diagram.pieces[i].face, i);
  }

  /// The intervals that all faces of the edge have, in no order. The two faces of an inner edge agree, unless a
  /// bisector runs along it. Empty where no generator reaches it. Cost: O(corners of the faces' pieces).
  std::vector<LabelInterval> of(EdgeId edge) const {
    std::vector<LabelInterval> labels;
    const HalfedgeId h = mesh_.halfedge(edge), twin = mesh_.twin(h);
    append(h, true, labels);
    if (twin.valid()) append(twin, false, labels);
    return labels;
  }

 private:
  /// Appends the sides of the pieces of h's face that lie on h.
  void append(HalfedgeId h, bool forwards, std::vector<LabelInterval>& labels) const {
    const FaceId f = Mesh::face(h);
    if (const GeneratorId whole = diagram_.face_label[f]; whole.valid()) labels.push_back({0, 1, whole});
    const auto first = first_piece_.find(f);
    if (first == first_piece_.end()) return;
    const int to = Mesh::corner(Mesh::next(h)), opposite = Mesh::corner(Mesh::previous(h));
    for (std::size_t i = first->second; i < diagram_.pieces.size() && diagram_.pieces[i].face == f; ++i) {
      const auto& corners = diagram_.pieces[i].corners;
      for (std::size_t k = 0; k < corners.size(); ++k) {
        const auto &a = corners[k], &b = corners[(k + 1) % corners.size()];
        if (a[opposite] != 0 || b[opposite] != 0) continue;
        const double from = forwards ? a[to] : 1 - a[to], end = forwards ? b[to] : 1 - b[to];
        labels.push_back({std::min(from, end), std::max(from, end), diagram_.pieces[i].generator});
      }
    }
  }

  const Mesh& mesh_;
  const Diagram& diagram_;
  std::map<FaceId, std::size_t> first_piece_;  // of each cut face
};

}  // namespace gvd
