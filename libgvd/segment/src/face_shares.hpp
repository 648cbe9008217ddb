#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

#include "base/barycentric.hpp"
#include "gvd/diagram.hpp"

namespace gvd {

/// The share of one cell in a face.
struct FaceShare {
  FaceId face;
  GeneratorId generator;
  double fraction = 0;  ///< of the face's area, in [0, 1]
};

/// The fraction of a generator among the shares of a face; 0 if it has none.
double fraction_of(std::span<const FaceShare> shares, GeneratorId generator);

/// The fraction of its face's area that a piece covers, in [0, 1]. A piece that rounding has made clockwise has 0.
inline double compute_area_fraction(const FacePiece& piece) { return std::clamp(area_share(piece.corners), 0.0, 1.0); }

/// The shares of the cells in cut faces, one for each cell of each face.
class FaceShares {
 public:
  explicit FaceShares(const Diagram& diagram);

  /// The shares of a face in descending order; among equal shares, the smaller generator comes first. Empty for a face
  /// that is not cut.
  std::span<const FaceShare> of(FaceId face) const {
    return {std::to_address(std::ranges::lower_bound(shares_, face, {}, &FaceShare::face)),
            std::to_address(std::ranges::upper_bound(shares_, face, {}, &FaceShare::face))};
  }
  /// All shares, ascending by face, and within a face as in `of`.
  const std::vector<FaceShare>& all() const { return shares_; }
  /// The fraction of a cell in a face; 0 if it has no share.
  double fraction(FaceId face, GeneratorId generator) const { return fraction_of(of(face), generator); }

 private:
  std::vector<FaceShare> shares_;
};

/// Throws Error{precondition} if the sizes or ids of `diagram` do not fit `mesh`.
void check_belongs(const Mesh& mesh, const Diagram& diagram);

}  // namespace gvd
