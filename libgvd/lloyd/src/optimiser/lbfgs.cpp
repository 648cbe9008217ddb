#include "lbfgs.hpp"

#include <utility>
#include <vector>

namespace gvd {
namespace {

/// The factor of the initial inverse Hessian that gives it the curvature of the latest pair.
double initial_factor(const StepHistory& history, const InverseHessian& initial) {
  if (history.pairs().empty()) return 1;
  const StepPair& latest = history.pairs().back();
  return dot(latest.step, latest.change) / dot(latest.change, initial(latest.change));
}

}  // namespace

TangentField lbfgs_direction(const StepHistory& history, const TangentField& gradient, const InverseHessian& initial) {
  TangentField q = gradient;
  std::vector<double> alphas;
  for (auto pair = history.pairs().rbegin(); pair != history.pairs().rend(); ++pair) {
    alphas.push_back(dot(pair->step, q) / dot(pair->step, pair->change));
    q = add_scaled(std::move(q), -alphas.back(), pair->change);
  }
  TangentField r = initial(q);
  const double factor = initial_factor(history, initial);
  for (Vec2& v : r) v *= factor;
  for (const StepPair& pair : history.pairs()) {
    const double beta = dot(pair.change, r) / dot(pair.step, pair.change);
    r = add_scaled(std::move(r), alphas.back() - beta, pair.step);
    alphas.pop_back();
  }
  for (Vec2& v : r) v = -v;
  return r;
}

}  // namespace gvd
