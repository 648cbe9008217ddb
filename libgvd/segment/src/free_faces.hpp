#pragma once

#include <cstdint>
#include <span>

#include "face_shares.hpp"
#include "gvd/diagram.hpp"
#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

using FreeFaceId = Id<struct FreeFaceTag>;

/// The faces whose label may be chosen: those in which two or more cells have a share. One face of each generator is
/// not free: of the faces round the generator with its label, the one with its largest share.
class FreeFaces {
 public:
  /// `label` has the labels to begin with. Refers to `shares`, which must outlive this. Cost: O(n).
  FreeFaces(const Mesh& mesh, const Diagram& diagram, const FaceShares& shares,
            const IdVector<FaceId, GeneratorId>& label);

  /// Their number. Ids are ascending by face.
  std::int32_t count() const { return static_cast<std::int32_t>(faces_.size()); }
  FaceId face(FreeFaceId i) const { return faces_[i].face; }
  /// Invalid for a face that is not free.
  FreeFaceId find(FaceId f) const { return id_[f]; }
  /// The cells with a share above 0, as FaceShares::of sorts them.
  std::span<const FaceShare> candidates(FreeFaceId i) const { return faces_[i].candidates; }
  /// The share of the cell that the face was labelled with to begin with.
  double first_fraction(FreeFaceId i) const { return faces_[i].first_fraction; }

 private:
  struct FreeFace {
    FaceId face;
    std::span<const FaceShare> candidates;
    double first_fraction;
  };

  IdVector<FreeFaceId, FreeFace> faces_;
  IdVector<FaceId, FreeFaceId> id_;
};

}  // namespace gvd
