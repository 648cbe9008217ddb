#pragma once

#include <span>
#include <vector>

#include "gvd/diagram.hpp"

namespace gvd {

/// A face of a cell, whole or clipped to the cell.
struct CellFace {
  FaceId face;
  const FacePiece* piece = nullptr;  ///< the piece of the face that belongs to the cell; null for a whole face
};

/// The faces of every cell. It refers to the diagram, which must outlive it.
class CellFaces {
 public:
  /// Cost: O(n).
  explicit CellFaces(const Diagram& diagram);

  std::size_t cell_count() const { return first_.size() - 1; }
  /// Whole faces first, then clipped ones, each group ascending by face.
  std::span<const CellFace> of(GeneratorId g) const {
    return std::span(faces_).subspan(first_[g.index()], first_[g.index() + 1] - first_[g.index()]);
  }

 private:
  std::vector<std::size_t> first_;  // the faces of cell g are first_[g] to first_[g + 1]
  std::vector<CellFace> faces_;
};

}  // namespace gvd
