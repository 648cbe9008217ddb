#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "mesh/working_mesh.hpp"

namespace gvd {

/// A point by its barycentric coordinates in a triangle, and how far it lies outside: the less the better.
struct PlacedInTriangle {
  Bary local{};
  double outside = 0;
};

/// The faces of a working mesh in each face of the input that it splits.
class SplitFaces {
 public:
  struct Part {
    FaceId parent, face;          // of the input, of the working mesh
    std::array<Bary, 3> corners;  // in the parent
  };

  /// Cost: O(n), and O(k log k) for k parts.
  explicit SplitFaces(const WorkingMesh& working) {
    for (const FaceId face : working.mesh().faces()) {
      if (working.is_split(face)) parts_.push_back({working.parent(face), face, working.corners(face)});
    }
    std::sort(parts_.begin(), parts_.end(),
              [](const Part& a, const Part& b) { return std::pair(a.parent, a.face) < std::pair(b.parent, b.face); });
  }

  /// The parts of a face of the input, ascending by face; none if it is not split. Cost: O(log k).
  std::span<const Part> parts_of(FaceId parent) const {
    return {std::ranges::lower_bound(parts_, parent, {}, &Part::parent),
            std::ranges::upper_bound(parts_, parent, {}, &Part::parent)};
  }

 private:
  std::vector<Part> parts_;  // ascending by parent and face
};

/// The part in which a point of its parent lies, and the point's coordinates there: the first one for which
/// `place(corners)`, a PlacedInTriangle, is the least outside. The face is invalid if there is no number for any.
template <class Place>
SurfacePoint locate_in_parts(std::span<const SplitFaces::Part> parts, Place place) {
  SurfacePoint best;
  double least = kInfinity;
  for (const SplitFaces::Part& part : parts) {
    const PlacedInTriangle placed = place(part.corners);
    if (!(placed.outside < least)) continue;
    least = placed.outside;
    best = {part.face, placed.local};
  }
  return best;
}

}  // namespace gvd
