#pragma once

#include <random>

namespace gvd::test {

/// Seeded random numbers that are equal with every standard library: the scaled output of the engine itself.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  /// In [low, high].
  double real(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_()) / static_cast<double>(std::mt19937::max()));
  }
  /// In 0 .. count - 1.
  int below(int count) { return static_cast<int>(engine_() % static_cast<unsigned>(count)); }

 private:
  std::mt19937 engine_;
};

}  // namespace gvd::test
