// Integrates |f| from four samples: bisection finds the roots of the cubic through the samples, which is split there.
#include "diagram/absolute_integral.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace gvd {
namespace {

/// Number of bisections that reduce an interval of length 1 to the spacing of doubles near 1.
constexpr int kBisections = 53;

/// The cubic through the four samples, in Lagrange's form.
double cubic(const std::array<double, 4>& samples, double x) {
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    double term = samples[i];
    for (std::size_t j = 0; j < 4; ++j) {
      if (j != i) term *= (x - kLobattoNodes[j]) / (kLobattoNodes[i] - kLobattoNodes[j]);
    }
    sum += term;
  }
  return sum;
}

double root_between(const std::array<double, 4>& samples, std::size_t node) {
  double low = kLobattoNodes[node], high = kLobattoNodes[node + 1];
  const bool negative = samples[node] < 0;
  for (int i = 0; i < kBisections; ++i) {
    const double middle = (low + high) / 2;
    ((cubic(samples, middle) < 0) == negative ? low : high) = middle;
  }
  return (low + high) / 2;
}

/// |integral of the cubic over [a, b]|, by the two-point Gauss rule, which is exact for cubics.
double absolute_integral(const std::array<double, 4>& samples, double a, double b) {
  const double middle = (a + b) / 2, to_node = (b - a) / 2 * std::numbers::inv_sqrt3;
  return std::abs(cubic(samples, middle - to_node) + cubic(samples, middle + to_node)) * (b - a) / 2;
}

}  // namespace

double integrate_absolute(const std::array<double, 4>& samples) {
  double sum = 0, start = 0;
  const auto cut_at = [&](double x) {
    sum += absolute_integral(samples, start, x);
    start = x;
  };
  for (std::size_t i = 0; i < 3; ++i) {
    if ((samples[i] < 0 && samples[i + 1] > 0) || (samples[i] > 0 && samples[i + 1] < 0)) {
      cut_at(root_between(samples, i));
    } else if (samples[i + 1] == 0) {
      cut_at(kLobattoNodes[i + 1]);
    }
  }
  cut_at(1);
  return sum;
}

}  // namespace gvd
