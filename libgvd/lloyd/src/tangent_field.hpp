#pragma once

#include <cstddef>
#include <vector>

#include "base/plane.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// One tangent vector for each generator, in the tangent plane at the generator (see geodesic_tracing.hpp).
using TangentField = std::vector<Vec2>;

/// The sum of the scalar products, in ascending order of the generators.
inline double dot(const TangentField& a, const TangentField& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i].dot(b[i]);
  return sum;
}

/// The field a + factor b.
inline TangentField add_scaled(TangentField a, double factor, const TangentField& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] += factor * b[i];
  return a;
}

/// Each vector times the factor.
inline TangentField scaled(TangentField field, double factor) {
  for (Vec2& v : field) v *= factor;
  return field;
}
/// Each vector times its own factor.
inline TangentField scaled(TangentField field, const std::vector<double>& factors) {
  for (std::size_t i = 0; i < field.size(); ++i) field[i] *= factors[i];
  return field;
}

/// A turn of a tangent plane: the cosine and sine of its angle.
using Turn = Vec2;

/// The turn that takes the unit vector `from` to the unit vector `to`.
inline Turn turn_between(const Vec2& from, const Vec2& to) { return {from.dot(to), cross(from, to)}; }

/// `v` after the turn.
inline Vec2 turned(const Turn& turn, const Vec2& v) {
  return {turn.x() * v.x() - turn.y() * v.y(), turn.y() * v.x() + turn.x() * v.y()};
}

/// Each vector after the turn of its generator.
inline TangentField turned(const std::vector<Turn>& turns, TangentField field) {
  for (std::size_t i = 0; i < field.size(); ++i) field[i] = turned(turns[i], field[i]);
  return field;
}

}  // namespace gvd
