#pragma once

#include <algorithm>
#include <cstdint>
#include <numbers>
#include <span>

#include "face_shares.hpp"
#include "gvd/segment.hpp"

namespace gvd {

/// Shortens the borders between the regions of `result`. Only free faces (see FreeFaces) change their label, and only
/// to the label of a cell with a share of the face.
///
/// Properties: (1) the border does not become longer; (2) the regions keep their topology (see RegionTopology); (3) no
/// region can lower the cost (see BorderCosts) by any set of free faces that it takes from others; (4) no two regions
/// can lower the cost by an exchange, and with only two regions the cost is the least possible. (3) and (4) hold if no
/// change was refused because of (2), and no cut gave up (see MinCut). Counts `smoothed_faces`. Cost: O(n + k) for k
/// shares in practice.
void smooth_borders(const Mesh& mesh, const Diagram& diagram, const FaceShares& shares, Segmentation& result,
                    const Progress& progress = {});

using FreeFaceId = Id<struct FreeFaceTag>;

/// The faces whose label may be chosen, because two or more cells have a share of them. One face of each generator is
/// not free: among the faces around the generator with its label, the face with its largest share.
class FreeFaces {
 public:
  /// `label` has the initial labels. Refers to `shares`, which must outlive this object. Cost: O(n).
  FreeFaces(const Mesh& mesh, const Diagram& diagram, const FaceShares& shares,
            const IdVector<FaceId, GeneratorId>& label);

  std::int32_t count() const { return faces_.count(); }
  /// All ids, ascending by face.
  IdRange<FreeFaceId> ids() const { return faces_.ids(); }
  FaceId face(FreeFaceId i) const { return faces_[i].face; }
  /// The id of a face; invalid for a face that is not free.
  FreeFaceId find(FaceId f) const { return id_[f]; }
  /// The cells with a share above 0, sorted as in FaceShares::of.
  std::span<const FaceShare> candidates(FreeFaceId i) const { return faces_[i].candidates; }
  /// The share of the cell with which the face was labelled initially.
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

/// The cost of a label with a smaller share than the initial label, as a fraction of the side of the equilateral
/// triangle that has the same height as the face has over its longest side.
///
/// Among borders of nearly the same length, this cost prefers the border near the bisectors. The height of a needle is
/// nearly 0, so its label costs nearly nothing; with its mean side instead, borders on needles would be far from
/// shortest.
inline constexpr double kShareWeight = 0.1;

/// The cost of the labels of faces, in mesh units: the length of the borders, and a small cost for small shares.
///
/// The cost of the initial labels is the length of their borders. No labels cost less than the length of their borders,
/// so labels that cost less than the initial ones have shorter borders.
class BorderCosts {
 public:
  /// Refers to all arguments, which must outlive this object.
  BorderCosts(const Mesh& mesh, const FreeFaces& free, const IdVector<FaceId, GeneratorId>& label)
      : mesh_(mesh), free_(free), label_(label) {}

  /// The cost of a label with this share of the face, without borders.
  double of_share(FreeFaceId i, double fraction) const {
    const double height = 2 * mesh_.area(free_.face(i)) / std::ranges::max(mesh_.shape(free_.face(i)).length);
    return kShareWeight * std::max(0.0, free_.first_fraction(i) - fraction) * height * std::numbers::inv_sqrt3 * 2;
  }

  /// The change of the cost of all labels if face i takes label `to`. Cost: O(k) for k candidates.
  double change(FreeFaceId i, GeneratorId to) const { return of_label(i, to) - of_label(i, label_[free_.face(i)]); }

  /// Calls visit(face, length) for the face across each side of face i; twice for a face with two common sides.
  template <class Visit>
  void for_each_side(FreeFaceId i, Visit visit) const {
    for (const HalfedgeId h : Mesh::halfedges(free_.face(i))) {
      if (mesh_.twin(h).valid()) visit(Mesh::face(mesh_.twin(h)), mesh_.length(h));
    }
  }

 private:
  double of_label(FreeFaceId i, GeneratorId g) const {
    double sum = of_share(i, fraction_of(free_.candidates(i), g));
    for_each_side(i, [&](FaceId f, double length) { sum += label_[f] == g ? 0 : length; });
    return sum;
  }

  const Mesh& mesh_;
  const FreeFaces& free_;
  const IdVector<FaceId, GeneratorId>& label_;
};

}  // namespace gvd
