// The cells along edges.
//
// A face that lies in one cell gives its label to its whole edges. A face that is cut into pieces has the label
// intervals of its edges in the sides of its pieces: those whose two ends have a 0 for the corner opposite to the edge.
// The labels of an inner edge come from both of its faces, so each point of it is labelled twice. The two agree, unless
// a bisector runs along the edge.

#include <algorithm>

#include "crease_steps.hpp"

namespace gvd {

EdgeLabels::EdgeLabels(const Mesh& mesh, const Diagram& diagram) : mesh_(mesh), diagram_(diagram) {
  for (std::size_t i = 0; i < diagram.pieces.size(); ++i) first_piece_.try_emplace(diagram.pieces[i].face, i);
}

std::vector<LabelInterval> EdgeLabels::of(EdgeId edge) const {
  std::vector<LabelInterval> labels;
  const HalfedgeId h = mesh_.halfedge(edge), twin = mesh_.twin(h);
  append(h, true, labels);
  if (twin.valid()) append(twin, false, labels);
  return labels;
}

/// Appends the sides of the pieces of h's face that lie on h.
void EdgeLabels::append(HalfedgeId h, bool forwards, std::vector<LabelInterval>& labels) const {
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

}  // namespace gvd
