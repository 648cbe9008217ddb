// Anderson's acceleration of linear fixed-point iterations.
#include "lloyd/random_field.hpp"
#include "optimiser/anderson.hpp"
#include "support/catch.hpp"

namespace gvd::test_anderson {

/// The step x -> M x + b - x, where M shrinks the vectors by different factors below 1.
TangentField plain_step(const TangentField& x, const TangentField& b) {
  TangentField step = b;
  for (std::size_t i = 0; i < x.size(); ++i) step[i] += (-1 + 0.9 + 0.03 * static_cast<double>(i % 3)) * x[i];
  return step;
}

TEST_CASE("anderson: without pairs the step is the plain one") {
  std::mt19937 random(1);
  const TangentField residual = test::random_field(4, random);
  CHECK(anderson_step(StepHistory(6), residual) == residual);
}

TEST_CASE("anderson: a linear iteration with three factors ends after four steps") {
  for (unsigned seed = 0; seed < 5; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    const TangentField b = test::random_field(12, random);
    TangentField x = test::random_field(12, random), residual = plain_step(x, b);
    StepHistory history(6);
    for (int i = 0; i < 4; ++i) {
      const TangentField step = anderson_step(history, residual);
      const TangentField next = add_scaled(x, 1, step), after = plain_step(next, b);
      history.add({step, add_scaled(after, -1, residual)});
      x = next;
      residual = after;
    }
    CHECK(test::length(residual) < 1e-9);
  }
}

}  // namespace gvd::test_anderson
