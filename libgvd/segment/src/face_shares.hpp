#pragma once

#include <span>
#include <vector>

#include "gvd/diagram.hpp"

namespace gvd {

/// The share of one cell in a face.
struct FaceShare {
  FaceId face;
  GeneratorId generator;
  double fraction = 0;  ///< of the face's area, in [0, 1]
};

/// The fraction of its face's area that a piece covers, in [0, 1]: twice its area in the plane of two barycentric
/// coordinates.
double compute_area_fraction(const FacePiece& piece);

/// The shares of the cells in the faces that are cut, one for each cell of a face.
class FaceShares {
 public:
  explicit FaceShares(const Diagram& diagram);

  /// In descending order, of equals the smaller generator first; empty for a face that is not cut.
  std::span<const FaceShare> of(FaceId face) const;
  /// All shares, ascending by face, then as `of` sorts them.
  const std::vector<FaceShare>& all() const { return shares_; }
  /// 0 where the cell has no share.
  double fraction(FaceId face, GeneratorId generator) const;

 private:
  std::vector<FaceShare> shares_;
};

/// Throws Error{precondition} if the sizes or ids of `diagram` don't fit `mesh`.
void check_belongs(const Mesh& mesh, const Diagram& diagram);

}  // namespace gvd
