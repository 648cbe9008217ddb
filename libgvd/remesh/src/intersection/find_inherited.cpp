#include <algorithm>
#include <iterator>

#include "gvd/self_intersections.hpp"
#include "intersection/face_boxes.hpp"

namespace gvd {
namespace {

double diagonal(const Box3& box) { return (box.high - box.low).norm(); }

/// The part of space in which a pair of faces intersects, with a margin.
Box3 common_box(const Mesh& mesh, const FacePair& pair) {
  const Box3 a = face_box(mesh, pair.first), b = face_box(mesh, pair.second);
  const Vec3 margin = Vec3::Constant(std::max(diagonal(a), diagonal(b)) / 2);
  return {a.low.cwiseMax(b.low) - margin, a.high.cwiseMin(b.high) + margin};
}

}  // namespace

std::vector<FacePair> find_inherited(const Mesh& surface, const Mesh& remesh, const std::vector<FacePair>& pairs,
                                     int threads) {
  std::vector<FacePair> inherited;
  if (pairs.empty()) return inherited;
  const std::vector<FacePair> given = find_self_intersections(surface, threads);
  const auto is_inherited = [&](const FacePair& pair) {
    const Box3 box = common_box(remesh, pair);
    return std::any_of(given.begin(), given.end(), [&](const FacePair& other) {
      return overlap(box, face_box(surface, other.first)) && overlap(box, face_box(surface, other.second));
    });
  };
  std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(inherited), is_inherited);
  return inherited;
}

}  // namespace gvd
