#include "mesh/split_faces.hpp"

#include <algorithm>
#include <utility>

namespace gvd {

SplitFaces::SplitFaces(const WorkingMesh& working) {
  for (std::int32_t f = 0; f < working.mesh().face_count(); ++f) {
    const FaceId face(f);
    if (!working.is_split(face)) continue;
    const auto corner = [&](const Bary& bary) { return working.parent_bary(face, bary); };
    parts_.push_back({working.parent(face), face, {corner({1, 0, 0}), corner({0, 1, 0}), corner({0, 0, 1})}});
  }
  std::sort(parts_.begin(), parts_.end(),
            [](const Part& a, const Part& b) { return std::pair(a.parent, a.face) < std::pair(b.parent, b.face); });
}

std::span<const SplitFaces::Part> SplitFaces::parts_of(FaceId parent) const {
  const auto first = std::lower_bound(parts_.begin(), parts_.end(), parent,
                                      [](const Part& part, FaceId f) { return part.parent < f; });
  auto last = first;
  while (last != parts_.end() && last->parent == parent) ++last;
  return {first, last};
}

}  // namespace gvd
