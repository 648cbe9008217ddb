// L-BFGS on functions whose minimum is known.
// The length of a step after one that was too long.
// Functions of symmetric matrices by the Lanczos process.
#include <cmath>
#include <limits>

#include "lloyd/states.hpp"
#include "optimiser.hpp"
#include "support/catch.hpp"

namespace gvd::test_optimiser {

/// A function of tangent vectors, and its gradient.
struct Function {
  std::function<double(const TangentField&)> value;
  std::function<TangentField(const TangentField&)> gradient;
};

TangentField same(const TangentField& field) { return field; }

/// Descends by at most `iterations` steps with backtracking, and requires that every step lowers the value.
TangentField minimize(const Function& f, TangentField x, int iterations, std::size_t memory) {
  StepHistory history(memory);
  TangentField gradient = f.gradient(x);
  for (int i = 0; i < iterations && test::length(gradient) > 1e-10; ++i) {
    const TangentField direction = lbfgs_direction(history, gradient, same);
    const double slope = dot(direction, gradient), before = f.value(x);
    REQUIRE(slope < 0);
    double scale = 1;
    TangentField next = add_scaled(x, scale, direction);
    while (f.value(next) > before + kSufficientFall * scale * slope && scale > 1e-20) {
      scale = shorter_scale(scale, slope, f.value(next) - before);
      next = add_scaled(x, scale, direction);
    }
    const TangentField end = f.gradient(next);
    StepPair pair{add_scaled(next, -1, x), add_scaled(end, -1, gradient)};
    if (dot(pair.step, pair.change) > 0) history.add(std::move(pair));
    x = std::move(next);
    gradient = end;
  }
  return x;
}

/// sum of c |x_i - p_i|^2 / 2, where the factors c lie between 1 and 1000.
Function make_quadratic(const TangentField& minimum) {
  const auto factor = [](std::size_t i) { return 1 + 999 * static_cast<double>(i % 7) / 6; };
  const auto gradient = [=](const TangentField& x) {
    TangentField g = add_scaled(x, -1, minimum);
    for (std::size_t i = 0; i < g.size(); ++i) g[i] *= factor(i);
    return g;
  };
  return {[=](const TangentField& x) { return 0.5 * dot(gradient(x), add_scaled(x, -1, minimum)); }, gradient};
}

/// Rosenbrock's function of each vector; its minimum is (1, 1).
Function make_rosenbrock() {
  const auto value = [](const TangentField& x) {
    double sum = 0;
    for (const Vec2& v : x) sum += 100 * std::pow(v.y() - v.x() * v.x(), 2) + std::pow(1 - v.x(), 2);
    return sum;
  };
  const auto gradient = [](const TangentField& x) {
    TangentField g;
    for (const Vec2& v : x) {
      const double across = v.y() - v.x() * v.x();
      g.emplace_back(-400 * v.x() * across - 2 * (1 - v.x()), 200 * across);
    }
    return g;
  };
  return {value, gradient};
}

TEST_CASE("lbfgs: the minimum of a quadratic function with factors from 1 to 1000") {
  std::mt19937 random(1);
  const TangentField minimum = test::random_field(40, random), start(40, Vec2::Zero());
  const TangentField found = minimize(make_quadratic(minimum), start, 60, 8);
  CHECK(test::length(add_scaled(found, -1, minimum)) < 1e-8);
}

TEST_CASE("lbfgs: Rosenbrock's valley is followed to its end, with any memory from 3 on") {
  for (const std::size_t memory : {3, 7, 20}) {
    for (unsigned seed = 0; seed < 5; ++seed) {
      CAPTURE(memory, seed);
      std::mt19937 random(seed);
      const TangentField found = minimize(make_rosenbrock(), test::random_field(3, random), 300, memory);
      CHECK(test::length(add_scaled(found, -1, TangentField(3, Vec2(1, 1)))) < 1e-6);
    }
  }
}

TEST_CASE("lbfgs: without pairs the direction is that of the initial inverse Hessian") {
  std::mt19937 random(3);
  const TangentField gradient = test::random_field(5, random);
  const auto half = [](const TangentField& field) { return add_scaled(field, -0.5, field); };
  const TangentField direction = lbfgs_direction(StepHistory(7), gradient, half);
  CHECK(test::length(add_scaled(direction, 0.5, gradient)) < 1e-15);
}

TEST_CASE("lbfgs: after a pair the inverse Hessian takes its change to its step") {
  std::mt19937 random(4);
  StepHistory history(7);
  for (int i = 0; i < 3; ++i) {
    StepPair pair{test::random_field(6, random), test::random_field(6, random)};
    if (dot(pair.step, pair.change) < 0) pair.change = add_scaled(pair.change, -2, pair.change);
    history.add(std::move(pair));
  }
  const StepPair& latest = history.pairs().back();
  const TangentField step = lbfgs_direction(history, latest.change, same);
  CHECK(test::length(add_scaled(step, 1, latest.step)) < 1e-12);
}

TEST_CASE("line search: the lowest point of a parabola is found") {
  // f(t) = -2 t + 4 t^2 is lowest at 1/4.
  CHECK(shorter_scale(1, -2, 2) == Approx(0.25));
  CHECK(shorter_scale(0.8, -2, -1.6 + 2.56) == Approx(0.25));
}

TEST_CASE("line search: every scale is a tenth to a half of the one before") {
  for (const double rise : {-0.5, 0.0, 1e-9, 1.0, 1e9, std::numeric_limits<double>::infinity()}) {
    const double scale = shorter_scale(0.3, -2, rise);
    CHECK(scale >= 0.03);
    CHECK(scale <= 0.15);
  }
}

double factor(std::size_t i) { return 0.2 * static_cast<double>(i % 5) - 0.3; }

TangentField scaled_each(TangentField field, const std::function<double(double)>& f) {
  for (std::size_t i = 0; i < field.size(); ++i) field[i] *= f(factor(i));
  return field;
}

TEST_CASE("lanczos: a function of a matrix with five eigenvalues is exact after five steps, and stays so") {
  std::mt19937 random(2);
  const TangentField b = test::random_field(30, random);
  const auto multiply = [](const TangentField& x) { return scaled_each(x, [](double e) { return e; }); };
  for (const int steps : {5, 6, 20}) {
    for (const auto& f : std::vector<std::function<double(double)>>{
             [](double e) { return std::exp(e); }, [](double e) { return 1 / std::max(std::abs(1 - e), 0.1); }}) {
      const TangentField exact = scaled_each(b, f);
      CHECK(test::length(add_scaled(apply_matrix_function(multiply, f, b, steps), -1, exact)) < 1e-10);
    }
  }
}

TEST_CASE("lanczos: the product with a zero field is zero, and one step is a multiple of the field") {
  const auto multiply = [](const TangentField& x) { return scaled_each(x, [](double e) { return e; }); };
  const auto inverse = [](double e) { return 1 / (1 - e); };
  const TangentField zero(4, Vec2::Zero()), ones(4, Vec2(1, 1));
  CHECK(apply_matrix_function(multiply, inverse, zero, 20) == zero);
  const TangentField once = apply_matrix_function(multiply, inverse, ones, 1);
  for (const Vec2& v : once) CHECK((v - once[0].x() * Vec2(1, 1)).norm() < 1e-14);
}

}  // namespace gvd::test_optimiser
