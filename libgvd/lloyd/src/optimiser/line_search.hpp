#pragma once

#include <algorithm>
#include <cmath>

namespace gvd {

/// Least fall of the energy, as a fraction of the slope times the scale (Armijo's condition).
inline constexpr double kSufficientFall = 1e-4;

/// The scale to try after one at which the energy did not fall enough: the lowest point of the parabola through what is
/// known, between a tenth and a half of the scale.
/// Inputs: `scale` of the steps that was tried; `slope` of the energy at scale 0, < 0; `rise` of the energy, which is
///         more than kSufficientFall * scale * slope.
/// Source: Nocedal and Wright, Numerical Optimization, 2006, section 3.5.
inline double shorter_scale(double scale, double slope, double rise) {
  if (!std::isfinite(rise)) return 0.1 * scale;
  const double lowest = -slope * scale * scale / (2 * (rise - slope * scale));
  return std::clamp(lowest, 0.1 * scale, 0.5 * scale);
}

}  // namespace gvd
