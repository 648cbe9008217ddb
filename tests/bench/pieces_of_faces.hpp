#pragma once

#include <vector>

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

}  // namespace gvd::test
