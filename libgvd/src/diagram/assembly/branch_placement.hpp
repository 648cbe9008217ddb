#pragma once

#include <optional>

#include "base/barycentric.hpp"
#include "diagram/assembly/face_polygon.hpp"

namespace gvd {

/// Moves guessed branch points to where the arcs that end there can't cross: to the nearest valid point on the way from
/// a point that is valid for certain.
class BranchPlacement {
 public:
  /// `is_accurate`: whether the guesses come from distances that can confirm branch points. Then they are kept as near
  /// to a side, and as much beyond another arc, as ties demand.
  explicit BranchPlacement(bool is_accurate) : is_accurate_(is_accurate) {}

  /// For a polygon of all three crossings of the face: strictly inside the face.
  Bary place_in_face(const FacePolygon& polygon, const std::optional<Bary>& wanted) const;
  /// For a polygon of three corners: inside of it.
  Bary place_in_polygon(const FacePolygon& polygon, const std::optional<Bary>& wanted) const;
  /// For the end of interval i, whose two corners the branch point replaces: inside of the polygon, and such that what
  /// remains of it is convex.
  Bary place_at_interval(const FacePolygon& polygon, std::size_t i, const std::optional<Bary>& wanted) const;

 private:
  double inversion() const { return is_accurate_ ? kTieInversion : 0; }

  bool is_accurate_;
};

}  // namespace gvd
