#pragma once

#include <array>
#include <vector>

namespace gvd::paper {

/// A convex polygon in a face: barycentric coordinates of its corners, counter-clockwise.
using Polygon = std::vector<std::array<double, 3>>;

/// The whole face.
inline Polygon whole_face() { return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}; }

/// A linear function in a face: its values at the three corners.
using LinearForm = std::array<double, 3>;

/// Values of a form at or below this fraction of its largest corner value are 0. Dimensionless: a hundred times the
/// rounding error of a sum of three products.
inline constexpr double kZeroValue = 1e-13;

/// The form's value at a point; exactly 0 where rounding leaves the sign open.
double evaluate(const LinearForm& form, const std::array<double, 3>& bary);

/// The part of a convex polygon where the form is >= 0; empty where that part has no interior.
///
/// Source: Sutherland and Hodgman 1974, for one line. Points on a side of the face stay on it exactly.
/// `keep_zero`: what to return where the form is 0 at every corner of the polygon: all of it, or nothing. Of two
/// generators that are equally near to a whole face, one has to have it.
Polygon clip_polygon(const Polygon& polygon, const LinearForm& form, bool keep_zero);

}  // namespace gvd::paper
