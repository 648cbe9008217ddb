#include "pieces/clip_polygon.hpp"

#include <algorithm>
#include <cmath>

#include "base/barycentric.hpp"

namespace gvd::paper {

double evaluate(const LinearForm& form, const Bary& bary) {
  const double value = interpolate(bary, form[0], form[1], form[2]);
  const double scale = std::max({std::abs(form[0]), std::abs(form[1]), std::abs(form[2])});
  return std::abs(value) <= kZeroValue * scale ? 0 : value;
}

Polygon clip_polygon(const Polygon& polygon, const LinearForm& form, bool keep_zero) {
  std::vector<double> values;
  for (const Bary& corner : polygon) values.push_back(evaluate(form, corner));
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  if (values.empty() || *least > 0) return polygon;
  if (*most == 0) return *least == 0 && keep_zero ? polygon : Polygon();
  if (*most < 0) return {};
  if (*least == 0) return polygon;
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t j = (i + 1) % polygon.size();
    if (values[i] >= 0) kept.push_back(polygon[i]);
    if (values[i] * values[j] < 0) kept.push_back(mix(polygon[i], polygon[j], values[i] / (values[i] - values[j])));
  }
  return kept;
}

}  // namespace gvd::paper
