#include "cell_faces.hpp"

namespace gvd {

CellFaces::CellFaces(const Diagram& diagram) : first_(diagram.generators.size() + 1, 0) {
  const auto for_each_cell_face = [&](const auto& visit) {
    for (std::size_t f = 0; f < diagram.face_label.size(); ++f) {
      const FaceId face(static_cast<std::int64_t>(f));
      if (diagram.face_label[face].valid()) visit(diagram.face_label[face], CellFace{face, nullptr});
    }
    for (const FacePiece& piece : diagram.pieces) visit(piece.generator, CellFace{piece.face, &piece});
  };
  for_each_cell_face([&](GeneratorId g, const CellFace&) { ++first_[g.index() + 1]; });
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  faces_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for_each_cell_face([&](GeneratorId g, const CellFace& face) { faces_[next[g.index()]++] = face; });
}

}  // namespace gvd
