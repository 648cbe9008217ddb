#include "creases/edge_labels.hpp"

#include <algorithm>

namespace gvd {

EdgeLabels::EdgeLabels(const Mesh& mesh, const Diagram& diagram) : mesh_(mesh), diagram_(diagram) {
  for (std::size_t i = 0; i < diagram.pieces.size(); ++i) first_piece_.try_emplace(diagram.pieces[i].face, i);
}

std::vector<EdgeLabel> EdgeLabels::of(EdgeId edge) const {
  std::vector<EdgeLabel> labels;
  const HalfedgeId h = mesh_.halfedge(edge), twin = mesh_.twin(h);
  append(h, true, labels);
  if (twin.valid()) append(twin, false, labels);
  return labels;
}

/// The sides of the pieces of h's face that lie on h.
void EdgeLabels::append(HalfedgeId h, bool forwards, std::vector<EdgeLabel>& labels) const {
  const FaceId f = Mesh::face(h);
  if (const GeneratorId whole = diagram_.face_label[f]; whole.valid()) labels.push_back({0, 1, whole});
  const auto first = first_piece_.find(f);
  if (first == first_piece_.end()) return;
  const auto to = static_cast<std::size_t>(Mesh::corner(Mesh::next(h)));
  const auto opposite = static_cast<std::size_t>(Mesh::corner(Mesh::previous(h)));
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
