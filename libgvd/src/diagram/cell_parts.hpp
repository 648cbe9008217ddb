#pragma once

#include <algorithm>
#include <memory>
#include <span>

#include "base/barycentric.hpp"
#include "gvd/diagram.hpp"
#include "gvd/ids.hpp"

// The parts of the cells in the faces of the mesh: whole faces, and the pieces of faces that bisectors cut.

namespace gvd {

/// A part of one face that belongs to one cell.
struct FacePart {
  FaceId face;
  GeneratorId generator;
  std::span<const Bary> corners;  ///< counter-clockwise; the three corners of the face if the cell has all of it
};

inline FacePart part_of(const FacePiece& piece) { return {piece.face, piece.generator, piece.corners}; }

/// The pieces of a face that bisectors cut; none for any other face. Cost: O(log p) for p pieces of the diagram.
inline std::span<const FacePiece> pieces_in(const Diagram& diagram, FaceId f) {
  const auto begin = std::ranges::lower_bound(diagram.pieces, f, {}, &FacePiece::face);
  const auto end = std::find_if(begin, diagram.pieces.end(), [f](const FacePiece& piece) { return piece.face != f; });
  return {std::to_address(begin), std::to_address(end)};
}

/// Calls visit(FacePart) for the parts of a face that belong to cells, in the order of the diagram's pieces. Cost: O(1)
/// for a face in one cell; otherwise O(log p) for p pieces of the diagram, and the parts of the face.
template <class Visit>
void for_each_cell_part(const Diagram& diagram, FaceId f, const Visit& visit) {
  const GeneratorId whole = diagram.face_label[f];
  if (whole.valid()) return visit(FacePart{f, whole, kWholeTriangle});
  for (const FacePiece& piece : pieces_in(diagram, f)) visit(part_of(piece));
}

/// Calls visit(FacePart) for all faces: first whole faces, ascending, then the pieces of cut faces. Cost: O(n).
template <class Visit>
void for_each_cell_part(const Diagram& diagram, const Visit& visit) {
  for (const FaceId f : diagram.face_label.ids()) {
    if (diagram.face_label[f].valid()) visit(FacePart{f, diagram.face_label[f], kWholeTriangle});
  }
  for (const FacePiece& piece : diagram.pieces) visit(part_of(piece));
}

}  // namespace gvd
