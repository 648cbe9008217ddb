// The lower envelope of functions over a triangle: its parts cover the triangle, and each has the least function.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "lower_envelope.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace gvd::test_lower_envelope {

using Function = std::array<double, 3>;

double value(const Function& f, const Bary& at) { return at[0] * f[0] + at[1] * f[1] + at[2] * f[2]; }

/// The share of the triangle that a part covers.
double share_of(const EnvelopePart& part) {
  double twice = 0;
  for (std::size_t i = 0; i < part.corners.size(); ++i) {
    const Bary &a = part.corners[i], &b = part.corners[(i + 1) % part.corners.size()];
    twice += a[1] * b[2] - a[2] * b[1];
  }
  return twice;
}

/// Checks that each part has the least function at its corners, with equal functions beyond its sides, and that the
/// parts cover the triangle.
void check_envelope(const std::vector<Function>& functions) {
  LowerEnvelope envelope;
  double covered = 0;
  for (const EnvelopePart& part : envelope.compute(functions)) {
    REQUIRE(part.corners.size() == part.across.size());
    covered += share_of(part);
    for (std::size_t i = 0; i < part.corners.size(); ++i) {
      const Bary& at = part.corners[i];
      double least = value(functions[0], at);
      for (const Function& f : functions) least = std::min(least, value(f, at));
      REQUIRE(value(functions[part.function], at) == Approx(least).margin(1e-11));
      if (part.across[i] == kTriangleSide) continue;
      const Bary& next = part.corners[(i + 1) % part.corners.size()];
      for (const Bary& end : {at, next}) {
        REQUIRE(value(functions[part.across[i]], end) == Approx(value(functions[part.function], end)).margin(1e-11));
      }
    }
  }
  REQUIRE(covered == Approx(1).epsilon(1e-9));
}

TEST_CASE("lower envelope: a single function has the whole triangle") {
  LowerEnvelope envelope;
  const auto parts = envelope.compute({{1, 2, 3}});
  REQUIRE(parts.size() == 1);
  CHECK(parts[0].function == 0);
  CHECK(share_of(parts[0]) == 1);
}

TEST_CASE("lower envelope: among equal functions the first one counts") {
  LowerEnvelope envelope;
  const auto parts = envelope.compute({{2, 2, 2}, {1, 1, 1}, {1, 1, 1}});
  REQUIRE(parts.size() == 1);
  CHECK(parts[0].function == 1);
}

TEST_CASE("lower envelope: squared distances of any number of points, all near the triangle") {
  test::Random random(4);
  const std::array<std::array<double, 2>, 3> corners{{{0, 0}, {1, 0}, {0, 1}}};
  for (const int count : {2, 3, 7, 8, 9, 10, 17, 60}) {
    for (int round = 0; round < 20; ++round) {
      CAPTURE(count, round);
      std::vector<Function> functions(count);
      for (Function& f : functions) {
        const double x = random.real(0, 1), y = random.real(0, 1);
        for (std::size_t i = 0; i < 3; ++i) {
          f[i] = std::pow(corners[i][0] - x, 2) + std::pow(corners[i][1] - y, 2);
        }
      }
      check_envelope(functions);
    }
  }
}

TEST_CASE("lower envelope: a needle that crosses hundreds of cells has a part of each") {
  // Points along the long side of a triangle: each is the nearest one somewhere.
  const int count = 300;
  std::vector<Function> functions;
  for (int i = 0; i < count; ++i) {
    const double x = (i + 0.5) / count;
    functions.push_back({x * x, (1 - x) * (1 - x), (x - 0.5) * (x - 0.5) + 1e-12});
  }
  check_envelope(functions);
  LowerEnvelope envelope;
  CHECK(envelope.compute(functions).size() == std::size_t(count));
}

}  // namespace gvd::test_lower_envelope
