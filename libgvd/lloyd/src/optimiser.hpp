#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <utility>
#include <vector>

#include "base/plane.hpp"
#include "gvd/vec.hpp"

// Fields of tangent vectors, and methods of optimisation on them. Nothing here depends on a mesh.

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

/// Multiplies each vector by the factor.
inline TangentField scaled(TangentField field, double factor) {
  for (Vec2& v : field) v *= factor;
  return field;
}
/// Multiplies each vector by its own factor.
inline TangentField scaled(TangentField field, const std::vector<double>& factors) {
  for (std::size_t i = 0; i < field.size(); ++i) field[i] *= factors[i];
  return field;
}

/// A rotation of a tangent plane, as the cosine and sine of its angle.
using Turn = Vec2;

/// The rotation that takes the unit vector `from` to the unit vector `to`.
inline Turn turn_between(const Vec2& from, const Vec2& to) { return {from.dot(to), cross(from, to)}; }

/// `v` after the rotation.
inline Vec2 turned(const Turn& turn, const Vec2& v) {
  return {turn.x() * v.x() - turn.y() * v.y(), turn.y() * v.x() + turn.x() * v.y()};
}

/// Rotates each vector by the turn of its generator.
inline TangentField turned(const std::vector<Turn>& turns, TangentField field) {
  for (std::size_t i = 0; i < field.size(); ++i) field[i] = turned(turns[i], field[i]);
  return field;
}

/// A step of all generators, and the change of the energy's gradient by it.
struct StepPair {
  TangentField step;    ///< mesh units
  TangentField change;  ///< mesh units cubed
};

/// The latest steps, oldest first. All vectors lie in the tangent planes at the present generators; call `transport`
/// when the generators move.
class StepHistory {
 public:
  explicit StepHistory(std::size_t memory) : memory_(memory) {}

  /// Adds a pair, given at the present generators, and drops the oldest pair if there are more than `memory`.
  void add(StepPair pair) {
    pairs_.push_back(std::move(pair));
    if (pairs_.size() > memory_) pairs_.pop_front();
  }
  /// Transports all vectors in parallel. `turns` are the rotations of the tangent planes along the generators' paths.
  void transport(const std::vector<Turn>& turns) {
    for (StepPair& pair : pairs_) {
      pair.step = turned(turns, std::move(pair.step));
      pair.change = turned(turns, std::move(pair.change));
    }
  }
  void clear() { pairs_.clear(); }
  const std::deque<StepPair>& pairs() const { return pairs_; }

 private:
  std::size_t memory_;
  std::deque<StepPair> pairs_;
};

/// A linear map of fields.
using FieldMap = std::function<TangentField(const TangentField&)>;

/// The direction of descent of the L-BFGS method: minus the product of the approximate inverse Hessian and `gradient`.
///
/// Source:  Nocedal and Wright, Numerical Optimization, 2006, algorithm 7.4 (two-loop recursion).
/// Inputs:  pairs of steps and changes of the gradient, each of positive curvature (step . change > 0);
/// `initial_inverse`: the product with the initial inverse Hessian, which is symmetric and positive
/// definite; the latest pair determines a factor.
/// Returns: a direction d with d . gradient < 0, unless the gradient is zero. Without pairs, -initial_inverse(gradient).
/// Cost: O(pairs x generators), and two calls of `initial_inverse`.
TangentField lbfgs_direction(const StepHistory& history, const TangentField& gradient, const FieldMap& initial_inverse);

/// The product of f(A) and `b`, where `multiply` is the product with a symmetric matrix A, and f acts on A's
/// eigenvalues.
///
/// Source:  Golub and Van Loan, Matrix Computations, 2013, section 10.1 (Lanczos process), with reorthogonalisation.
/// Returns: the best approximation in the space of b, A b, ... A^(steps - 1) b; exact if that space is invariant.
/// Cost: `steps` products with A, O(steps^2 x generators).
TangentField apply_matrix_function(const FieldMap& multiply, const std::function<double(double)>& f,
                                   const TangentField& b, int steps);

/// The least sufficient fall of the energy, as a fraction of the slope times the scale (Armijo's condition).
inline constexpr double kSufficientFall = 1e-4;

/// The next scale to try if the energy did not fall enough: the minimum of the parabola through the known values,
/// between a tenth and a half of the present scale.
/// Inputs: `scale` of the steps that was tried; `slope` of the energy at scale 0, < 0; `rise` of the energy, which is
///         more than kSufficientFall * scale * slope.
/// Source: Nocedal and Wright, Numerical Optimization, 2006, section 3.5.
double shorter_scale(double scale, double slope, double rise);

}  // namespace gvd
