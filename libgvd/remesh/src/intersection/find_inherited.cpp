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

/// Whether a box overlaps those of both faces of a pair.
class PairBoxes {
 public:
  /// `pairs` ascend. Both must outlive this. Cost: O(n), and O(q log q) for q pairs.
  PairBoxes(const Mesh& mesh, const std::vector<FacePair>& pairs)
      : mesh_(mesh), pairs_(pairs), firsts_(mesh, first_faces(pairs)) {}

  bool any_overlaps(const Box3& box) const {
    return firsts_.any_of(box, [&](FaceId first) { return overlaps_partner(first, box); });
  }

 private:
  static std::vector<FaceId> first_faces(const std::vector<FacePair>& pairs) {
    std::vector<FaceId> faces;
    for (const FacePair& pair : pairs) {
      if (faces.empty() || faces.back() != pair.first) faces.push_back(pair.first);
    }
    return faces;
  }

  bool overlaps_partner(FaceId first, const Box3& box) const {
    const auto is_before = [](const FacePair& pair, FaceId f) { return pair.first < f; };
    auto pair = std::lower_bound(pairs_.begin(), pairs_.end(), first, is_before);
    for (; pair != pairs_.end() && pair->first == first; ++pair) {
      if (overlap(box, face_box(mesh_, pair->second))) return true;
    }
    return false;
  }

  const Mesh& mesh_;
  const std::vector<FacePair>& pairs_;
  FaceBoxes firsts_;
};

}  // namespace

std::vector<FacePair> find_inherited(const Mesh& surface, const Mesh& remesh, const std::vector<FacePair>& pairs,
                                     int threads) {
  std::vector<FacePair> inherited;
  if (pairs.empty()) return inherited;
  const std::vector<FacePair> given = find_self_intersections(surface, threads);
  const PairBoxes near_given(surface, given);
  std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(inherited),
               [&](const FacePair& pair) { return near_given.any_overlaps(common_box(remesh, pair)); });
  return inherited;
}

}  // namespace gvd
