#include "free_faces.hpp"

#include <cstddef>
#include <vector>

#include "gvd/surface_point.hpp"

namespace gvd {
namespace {

double fraction_of(std::span<const FaceShare> shares, GeneratorId g) {
  for (const FaceShare& share : shares) {
    if (share.generator == g) return share.fraction;
  }
  return 0;
}

/// Marks the face of each generator that keeps its label.
IdVector<FaceId, char> hold_generators(const Mesh& mesh, const Diagram& diagram, const FaceShares& shares,
                                       const IdVector<FaceId, GeneratorId>& label) {
  IdVector<FaceId, char> held(label.size(), 0);
  for (std::size_t i = 0; i < diagram.generators.size(); ++i) {
    const GeneratorId g(i);
    FaceId best;
    double largest = 0;
    for (const FaceId f : faces_around(mesh, diagram.generators[i])) {
      if (label[f] != g) continue;
      const double fraction = diagram.face_label[f] == g ? 1 : shares.fraction(f, g);
      if (best.valid() && (fraction < largest || (fraction == largest && best < f))) continue;
      largest = fraction;
      best = f;
    }
    if (best.valid()) held[best] = 1;
  }
  return held;
}

}  // namespace

FreeFaces::FreeFaces(const Mesh& mesh, const Diagram& diagram, const FaceShares& shares,
                     const IdVector<FaceId, GeneratorId>& label)
    : id_(static_cast<std::size_t>(mesh.face_count())) {
  const IdVector<FaceId, char> held = hold_generators(mesh, diagram, shares, label);
  const std::vector<FaceShare>& all = shares.all();
  for (std::size_t first = 0, last = 0; first < all.size(); first = last) {
    const FaceId f = all[first].face;
    std::size_t owners = 0;
    for (; last < all.size() && all[last].face == f; ++last) owners += all[last].fraction > 0;
    if (owners < 2 || held[f]) continue;
    const auto candidates = std::span(all).subspan(first, owners);
    id_[f] = faces_.push_back({f, candidates, fraction_of(candidates, label[f])});
  }
}

}  // namespace gvd
