#include "pieces/working_pieces.hpp"

#include <algorithm>

namespace gvd::paper {

Pieces take_to_input(const WorkingMesh& working, Pieces pieces) {
  for (FacePiece& piece : pieces) {
    for (Bary& corner : piece.corners) corner = working.parent_bary(piece.face, corner);
    piece.face = working.parent(piece.face);
  }
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const FacePiece& a, const FacePiece& b) { return a.face < b.face; });
  return pieces;
}

}  // namespace gvd::paper
