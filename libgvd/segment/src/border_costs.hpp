#pragma once

#include <algorithm>

#include "free_faces.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// What a label with a smaller share than the first one costs, as a fraction of the face's mean side.
///
/// Of borders with nearly the same length it prefers the one near to the bisectors. With 0, borders are 1 % shorter,
/// but 20 to 40 % more area lies in regions of other cells. Where cells have five faces each, a fifth of the regions
/// shrink to one face then. With 0.25, borders are 1 to 2 % longer, and less area is wrong by 10 %.
inline constexpr double kShareWeight = 0.1;

/// The cost of the labels of faces, in mesh units: the length of the borders, and little for small shares.
///
/// The cost of the first labels is their border's length. No label costs less than its border, so labels that cost less
/// than the first ones have a shorter border.
class BorderCosts {
 public:
  BorderCosts(const Mesh& mesh, const FreeFaces& free, const IdVector<FaceId, GeneratorId>& label)
      : mesh_(mesh), free_(free), label_(label) {}

  /// Of a label with this share of the face, border apart.
  double of_share(FreeFaceId i, double fraction) const {
    const auto& [a, b, c] = mesh_.shape(free_.face(i)).length;
    return kShareWeight * std::max(0.0, free_.first_fraction(i) - fraction) * (a + b + c) / 3;
  }

  /// What the cost of all labels changes by if face i takes label `to`. Cost: O(k) for k candidates.
  double change(FreeFaceId i, GeneratorId to) const { return of_label(i, to) - of_label(i, label_[free_.face(i)]); }

  /// Calls visit(face, length) for the other face of each side of face i, twice for one with two sides in common.
  template <class Visit>
  void for_each_side(FreeFaceId i, Visit visit) const {
    for (int corner = 0; corner < 3; ++corner) {
      const HalfedgeId h = Mesh::halfedge(free_.face(i), corner), twin = mesh_.twin(h);
      if (twin.valid()) visit(Mesh::face(twin), mesh_.length(h));
    }
  }

 private:
  double of_label(FreeFaceId i, GeneratorId g) const {
    double fraction = 0;
    for (const FaceShare& share : free_.candidates(i)) fraction += share.generator == g ? share.fraction : 0;
    double sum = of_share(i, fraction);
    for_each_side(i, [&](FaceId f, double length) { sum += label_[f] == g ? 0 : length; });
    return sum;
  }

  const Mesh& mesh_;
  const FreeFaces& free_;
  const IdVector<FaceId, GeneratorId>& label_;
};

}  // namespace gvd
