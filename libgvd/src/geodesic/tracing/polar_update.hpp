#pragma once

#include <cmath>
#include <limits>
#include <numbers>

#include "base/plane.hpp"
#include "geodesic/marching/local_update.hpp"

namespace gvd {

/// A path to the corner D of a triangle A, B, D, given the distances at A and B.
struct PolarStep {
  enum class Kind { through_base, along_a, along_b };

  double distance = std::numeric_limits<double>::infinity();  ///< at D, mesh units
  Kind kind = Kind::along_a;
  double source_x = 0;  ///< of the unfolded source: its foot on the base, from A towards B; for through_base
  double depth = 0;     ///< of the unfolded source below the base, >= 0; for through_base
};

/// Distance at D. The distances at A and B determine a point source in the unfolded plane. If the segment from it to D
/// crosses the base AB, the path goes through the base; otherwise along AD or BD.
///
/// Source: Melvaer and Reimers (2012), section 3.1; the formula is that of update_circle.
/// Inputs: distances >= 0, mesh units. Properties: (1) symmetric in A and B; (2) exact for a planar point source.
/// Cost: O(1), two square roots.
inline PolarStep step_to_corner(const UpdateTriangle& t, double distance_a, double distance_b) {
  const auto along_edges = [&] {
    const double a = distance_a + t.side_a, b = distance_b + t.side_b;
    return a <= b ? PolarStep{a, PolarStep::Kind::along_a} : PolarStep{b, PolarStep::Kind::along_b};
  };
  const double source_x = apex_foot_by_inverse(t.base, t.inverse_base, distance_a, distance_b);
  const double depth_squared = (distance_a - source_x) * (distance_a + source_x);
  if (depth_squared < 0) return along_edges();
  const double depth = std::sqrt(depth_squared), span = depth + t.height;
  const double crossing = source_x * t.height + t.x * depth;  // divided by span: where the ray crosses the base
  if (crossing < 0 || crossing > t.base * span) return along_edges();
  const double dx = t.x - source_x;
  return {std::sqrt(dx * dx + span * span), PolarStep::Kind::through_base, source_x, depth};
}

/// The polar angle of D, in radians, from those of A and B. Through the base it is interpolated in the ratio of the
/// unfolded angles, across the smaller difference of the two. Along an edge it is that of the edge's other end.
inline double polar_angle(const UpdateTriangle& t, const PolarStep& step, double angle_a, double angle_b) {
  if (step.kind == PolarStep::Kind::along_a) return angle_a;
  if (step.kind == PolarStep::Kind::along_b) return angle_b;
  // Angles at the source from its vertical to the three corners.
  const double to_a = std::atan2(-step.source_x, step.depth);
  const double to_b = std::atan2(t.base - step.source_x, step.depth);
  const double to_d = std::atan2(t.x - step.source_x, step.depth + t.height);
  if (!(to_b > to_a)) return angle_a;
  return angle_a + (to_d - to_a) / (to_b - to_a) * std::remainder(angle_b - angle_a, 2 * std::numbers::pi);
}

}  // namespace gvd
