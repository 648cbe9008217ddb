#pragma once

namespace gvd {

/// Foot of a triangle's apex on its base, measured from the base's first end, from the lengths of the three sides; the
/// sides may be distances to a point source, whose image is then the apex. By the law of cosines. The difference of two
/// squares is a product, so that nothing cancels where the sides are long and nearly equal.
///
/// Inputs: mesh units, base > 0. Returns: mesh units; outside of [0, base] where an angle at the base is obtuse.
inline double apex_foot(double base, double first_side, double second_side) {
  return 0.5 * (base + (first_side - second_side) * (first_side + second_side) / base);
}

/// The same by 1 / base, for loops that have it at hand. It may differ from apex_foot in the last digit.
inline double apex_foot_by_inverse(double base, double inverse_base, double first_side, double second_side) {
  return 0.5 * (base + (first_side - second_side) * (first_side + second_side) * inverse_base);
}

}  // namespace gvd
