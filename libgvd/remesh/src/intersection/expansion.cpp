#include "intersection/expansion.hpp"

#include <cmath>
#include <cstddef>

namespace gvd {
namespace {

/// a + b as the rounded sum and its error (Two-Sum).
std::array<double, 2> exact_sum(double a, double b) {
  const double sum = a + b, second = sum - a, first = sum - second;
  return {sum, (a - first) + (b - second)};
}

/// a b as the rounded product and its error.
std::array<double, 2> exact_product(double a, double b) {
  const double product = a * b;
  return {product, std::fma(a, b, -product)};
}

}  // namespace

std::array<double, 2> exact_difference(double a, double b) { return exact_sum(a, -b); }

void Expansion::add(double value) {
  double carry = value;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < components_.size(); ++i) {
    const auto [sum, error] = exact_sum(carry, components_[i]);
    if (error != 0) components_[kept++] = error;
    carry = sum;
  }
  components_.resize(kept);
  if (carry != 0) components_.push_back(carry);
}

void Expansion::add_product(const std::array<double, 2>& a, const std::array<double, 2>& b) {
  for (const double x : a) {
    for (const double y : b) {
      if (x == 0 || y == 0) continue;
      for (const double part : exact_product(x, y)) add(part);
    }
  }
}

void Expansion::add_product(const std::array<double, 2>& a, const std::array<double, 2>& b,
                            const std::array<double, 2>& c) {
  for (const double x : a) {
    for (const double y : b) {
      if (x != 0 && y != 0) add_product(exact_product(x, y), c);
    }
  }
}

int Expansion::sign() const {
  if (components_.empty()) return 0;
  return components_.back() > 0 ? 1 : -1;
}

}  // namespace gvd
