#pragma once

#include <span>
#include <vector>

#include "gvd/diagram.hpp"

namespace gvd {

/// A face, or a piece of one, that belongs to a cell.
struct CellPart {
  FaceId face;
  const FacePiece* piece = nullptr;  ///< null: the whole face
};

/// The faces and pieces of every cell. It refers to the diagram, which must outlive it.
class CellRegions {
 public:
  /// Cost: O(n).
  explicit CellRegions(const Diagram& diagram);

  std::size_t cell_count() const { return first_.size() - 1; }
  /// Whole faces first, then pieces, each ascending by face.
  std::span<const CellPart> parts(GeneratorId g) const {
    return std::span(parts_).subspan(first_[g.index()], first_[g.index() + 1] - first_[g.index()]);
  }

 private:
  std::vector<std::size_t> first_;  // cell g's parts are first_[g] to first_[g + 1]
  std::vector<CellPart> parts_;
};

}  // namespace gvd
