#pragma once

#include <array>
#include <cmath>

#include "base/barycentric.hpp"
#include "gvd/front.hpp"
#include "gvd/ids.hpp"

namespace gvd {

/// A generator's distance over a triangle, in a form whose difference between two generators is linear in barycentric
/// coordinates: so bisectors are straight and a branch point is a 2 x 2 system.
///
/// With planar fronts the distance itself is interpolated (the paper's rough bisector). With circles it is the squared
/// distance: for a point source in the triangle's plane d(p)^2 = sum b_i d_i^2 - sum b_i b_j l_ij^2, whose last sum is
/// the same for every generator.
struct DistanceForm {
  GeneratorId generator;
  std::array<double, 3> corner;

  double at(const Bary& bary) const { return interpolate(bary, corner[0], corner[1], corner[2]); }
};

/// The form's value of one distance.
inline double form_value(Front front, double distance) {
  return front == Front::circle ? distance * std::abs(distance) : distance;
}

}  // namespace gvd
