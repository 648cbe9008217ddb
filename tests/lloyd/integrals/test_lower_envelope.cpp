// The lower envelope of linear functions over a triangle, beside their minimum at points.
#include <algorithm>
#include <cmath>

#include "integrals/lower_envelope.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace gvd::test_lower_envelope {

using Function = std::array<double, 3>;

double area(const EnvelopePart& part) {  // of the whole triangle: 1
  double sum = 0;
  for (std::size_t i = 0; i < part.corners.size(); ++i) {
    const Bary &a = part.corners[i], &b = part.corners[(i + 1) % part.corners.size()];
    sum += a[1] * b[2] - b[1] * a[2];
  }
  return sum;
}

double total_area(const std::vector<EnvelopePart>& parts) {
  double sum = 0;
  for (const EnvelopePart& part : parts) sum += area(part);
  return sum;
}

std::vector<EnvelopePart> lower_envelope(const std::vector<Function>& values) {
  LowerEnvelope envelope;
  const auto parts = envelope.compute(values);
  return {parts.begin(), parts.end()};
}

double value(const Function& f, const Bary& at) { return f[0] * at[0] + f[1] * at[1] + f[2] * at[2]; }

TEST_CASE("lower envelope: one function has the whole triangle, and of equal ones the first") {
  for (const std::size_t count : {1, 2, 3}) {
    const auto parts = lower_envelope(std::vector<Function>(count, {1, 2, 3}));
    REQUIRE(parts.size() == 1);
    CHECK(parts[0].function == 0);
    CHECK(parts[0].corners.size() == 3);
    CHECK(std::count(parts[0].across.begin(), parts[0].across.end(), kTriangleSide) == 3);
  }
  CHECK(lower_envelope({}).empty());
}

TEST_CASE("lower envelope: nothing is left of the one before") {
  LowerEnvelope envelope;
  CHECK(envelope.compute({{0, 1, 1}, {1, 0, 0}, {1, 1, 0}}).size() > 1);
  const auto parts = envelope.compute({{1, 2, 3}});
  REQUIRE(parts.size() == 1);
  CHECK(parts[0].corners.size() == 3);
  CHECK(envelope.compute({}).empty());
}

TEST_CASE("lower envelope: two functions cut the triangle along a line, and each knows the other") {
  const auto parts = lower_envelope({{0, 1, 1}, {1, 0, 0}});
  REQUIRE(parts.size() == 2);
  CHECK(area(parts[0]) == Approx(0.25));
  CHECK(area(parts[1]) == Approx(0.75));
  CHECK(std::count(parts[0].across.begin(), parts[0].across.end(), 1) == 1);
  CHECK(std::count(parts[1].across.begin(), parts[1].across.end(), 0) == 1);
}

TEST_CASE("lower envelope: parts are where their function is least, and cover the triangle") {
  test::Random random(1);
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<Function> values(static_cast<std::size_t>(1 + trial % 9));
    for (Function& f : values) f = {random.real(0, 1), random.real(0, 1), random.real(0, 1)};
    if (trial % 4 == 0) values.push_back(values[0]);
    if (trial % 5 == 0) values.push_back({values[0][0], random.real(0, 1), random.real(0, 1)});
    const auto parts = lower_envelope(values);
    CHECK(total_area(parts) == Approx(1).epsilon(1e-12));
    for (const EnvelopePart& part : parts) {
      for (std::size_t i = 0; i < part.corners.size(); ++i) {
        const Bary& at = part.corners[i];
        for (const Function& f : values) CHECK(value(values[part.function], at) <= value(f, at) + 1e-12);
        if (part.across[i] == kTriangleSide) continue;
        CHECK(std::abs(value(values[part.function], at) - value(values[part.across[i]], at)) < 1e-12);
      }
    }
  }
}

}  // namespace gvd::test_lower_envelope
