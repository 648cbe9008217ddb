#pragma once

#include <array>
#include <cmath>

#include "base/barycentric.hpp"
#include "gvd/front.hpp"
#include "gvd/ids.hpp"

namespace gvd {

/// A generator's distance over a triangle, in a form whose difference between two generators is linear in barycentric
/// coordinates. So bisectors are straight, and a branch point solves a 2 x 2 system.
///
/// With planar fronts the form is the distance, interpolated linearly from the corners. With circle fronts it is the
/// squared distance. For a point source in the triangle's plane d(p)^2 = sum b_i d_i^2 - sum b_i b_j l_ij^2. The last
/// sum is the same for every generator.
/// Source: not in the paper, whose rough bisectors join the midpoints of edges (section 4.2).
struct DistanceForm {
  GeneratorId generator;
  std::array<double, 3> corner;  ///< the form's values at the triangle's corners, by form_value

  double at(const Bary& bary) const { return interpolate(bary, corner[0], corner[1], corner[2]); }
};

/// The form's value for a distance in mesh units. The sign of a negative value is kept.
inline double form_value(Front front, double distance) {
  return front == Front::circle ? distance * std::abs(distance) : distance;
}

}  // namespace gvd
