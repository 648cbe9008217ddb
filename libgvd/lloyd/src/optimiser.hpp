#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <utility>
#include <vector>

#include "base/plane.hpp"
#include "gvd/vec.hpp"

// Fields of tangent vectors, and the methods of optimisation on them. Nothing here knows a mesh.

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

// optimiser.cpp

/// A step of all generators, and how much the gradient of the energy changed by it.
struct StepPair {
  TangentField step;    ///< mesh units
  TangentField change;  ///< mesh units cubed
};

/// The latest steps, oldest first. All vectors lie in the tangent planes at the present generators: `transport` takes
/// them along when the generators move.
class StepHistory {
 public:
  explicit StepHistory(std::size_t memory) : memory_(memory) {}

  /// Adds a pair, given at the present generators, and drops the oldest one beyond the memory.
  void add(StepPair pair) {
    pairs_.push_back(std::move(pair));
    if (pairs_.size() > memory_) pairs_.pop_front();
  }
  /// Parallel transport of all vectors: `turns` are those of the tangent planes along the generators' paths.
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
///          `initial_inverse`: the product with the inverse Hessian before the pairs, which is symmetric and positive
///          definite. The latest pair gives it a factor.
/// Returns: a direction d with d . gradient < 0, unless the gradient is zero. Without pairs, -initial_inverse(gradient).
/// Cost: O(pairs x generators), and two calls of `initial_inverse`.
TangentField lbfgs_direction(const StepHistory& history, const TangentField& gradient, const FieldMap& initial_inverse);

/// The product of f(A) and `b`, where A is the symmetric matrix of `multiply`, and f acts on its eigenvalues.
///
/// Source:  Golub and Van Loan, Matrix Computations, 2013, section 10.1 (Lanczos process), with reorthogonalisation.
/// Returns: the best approximation in the space of b, A b, ... A^(steps - 1) b; exact if that space is invariant.
/// Cost: `steps` products with A, O(steps^2 x generators).
TangentField apply_matrix_function(const FieldMap& multiply, const std::function<double(double)>& f,
                                   const TangentField& b, int steps);

/// Least fall of the energy, as a fraction of the slope times the scale (Armijo's condition).
inline constexpr double kSufficientFall = 1e-4;

/// The scale to try after one at which the energy did not fall enough: the lowest point of the parabola through what is
/// known, between a tenth and a half of the scale.
/// Inputs: `scale` of the steps that was tried; `slope` of the energy at scale 0, < 0; `rise` of the energy, which is
///         more than kSufficientFall * scale * slope.
/// Source: Nocedal and Wright, Numerical Optimization, 2006, section 3.5.
double shorter_scale(double scale, double slope, double rise);

}  // namespace gvd
