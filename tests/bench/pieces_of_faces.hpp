#pragma once

#include <vector>

#include "base/barycentric.hpp"
#include "pieces.hpp"

namespace gvd::test {

/// Every face whole, with the label that `label_of(FaceId)` gives it.
template <class LabelOf>
paper::Pieces whole_faces(const Mesh& mesh, LabelOf label_of) {
  paper::Pieces pieces;
  for (int f = 0; f < mesh.face_count(); ++f) {
    pieces.push_back({FaceId(f), GeneratorId(label_of(FaceId(f))), paper::whole_face()});
  }
  return pieces;
}

/// Sum of the areas of the pieces, square mesh units: that of the mesh, if they cover it.
inline double sum_areas(const Mesh& mesh, const paper::Pieces& pieces) {
  double sum = 0;
  for (const FacePiece& piece : pieces) sum += mesh.area(piece.face) * area_share(piece.corners);
  return sum;
}

}  // namespace gvd::test
