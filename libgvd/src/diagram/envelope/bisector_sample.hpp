#pragma once

#include <cmath>

#include "base/plane.hpp"
#include "diagram/envelope/source_distances.hpp"
#include "geodesic/distance_field.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// The shortest paths of two generators to a point, compared: how far the point is from their bisector. Mesh units.
struct BisectorSample {
  /// Rounding of a difference of two distances, as a fraction of them.
  static constexpr double kDifferenceRounding = 1e-15;

  Vec2 point;
  FaceSource::Path left, right;
  const FaceSource *left_source = nullptr, *right_source = nullptr;  ///< of the two paths

  /// Whether both generators have a path.
  bool is_known() const { return std::isfinite(left.distance) && std::isfinite(right.distance); }
  /// The difference of the distances: 0 on the bisector, < 0 on its left.
  double error() const { return left.distance - right.distance; }
  /// The part of the error that may be rounding.
  double rounding() const { return kDifferenceRounding * left.distance; }
  /// The gradient of the error.
  Vec2 gradient() const { return direction(point, left.from) - direction(point, right.from); }
  /// Direction of the bisector, with the left generator's cell on its left; not a unit vector.
  Vec2 tangent() const { return turned_left(gradient()); }
  /// How far along `across`, a unit vector, the two straight paths are equally long, by Newton's method to `precision`.
  /// Their images stay the same on the way, so that this may leave the bisector at a corner.
  double distance_to_bisector(const Vec2& across, double precision) const;
};

}  // namespace gvd
