#pragma once

#include <span>
#include <vector>

#include "gvd/diagram.hpp"

namespace gvd {

/// The part of a face that belongs to one cell.
struct FaceShare {
  FaceId face;
  GeneratorId generator;
  double part = 0;  ///< of the face's area, in [0, 1]
};

/// The part of its face that a piece covers, in [0, 1]: twice its area in the plane of two barycentric coordinates.
double compute_part(const FacePiece& piece);

/// The cells' shares in the cut faces, each cell once a face; found by face.
class FaceShares {
 public:
  explicit FaceShares(const Diagram& diagram);

  /// The largest share first, of equals the smaller generator; empty for a face that is not cut.
  std::span<const FaceShare> of(FaceId face) const;
  /// All shares, ascending by face.
  const std::vector<FaceShare>& all() const { return shares_; }
  /// 0 where the cell has none.
  double part(FaceId face, GeneratorId generator) const;

 private:
  std::vector<FaceShare> shares_;
};

/// Throws Error{precondition} where the sizes or ids of `diagram` are not those of a diagram of `mesh`.
void check_belongs(const Mesh& mesh, const Diagram& diagram);

}  // namespace gvd
