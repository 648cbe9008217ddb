// Functions of symmetric matrices by the Lanczos process.
#include <cmath>

#include "lloyd/random_field.hpp"
#include "optimiser/lanczos.hpp"
#include "support/catch.hpp"

namespace gvd::test_lanczos {

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

}  // namespace gvd::test_lanczos
