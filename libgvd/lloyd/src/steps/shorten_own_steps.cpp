#include "steps/shorten_own_steps.hpp"

#include <algorithm>
#include <cmath>

#include "optimiser/tangent_field.hpp"

namespace gvd {
namespace {

/// Bounds of the factor of one shortening.
constexpr double kLeastFactor = 0.1, kLargestFactor = 0.5;

}  // namespace

bool shorten_own_steps(const RelaxationState& before, const GeneratorMove& move, const RelaxationState& after,
                       std::vector<double>& scales) {
  const TangentField start = turned(move.turns, energy_gradient(before)), end = energy_gradient(after);
  bool is_any_shortened = false;
  for (std::size_t i = 0; i < scales.size(); ++i) {
    const double first = start[i].dot(move.step[i]), last = end[i].dot(move.step[i]);
    if (!(first < 0 && last > 0)) continue;
    scales[i] *= std::clamp(first / (first - last), kLeastFactor, kLargestFactor);
    is_any_shortened = true;
  }
  return is_any_shortened;
}

}  // namespace gvd
