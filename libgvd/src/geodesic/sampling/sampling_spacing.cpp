#include "geodesic/sampling/sampling_spacing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gvd/sampling.hpp"

namespace gvd {

double even_spacing(double area, std::int64_t count) {
  // Each point has two triangles of area sqrt(3) / 4 times the square of the side.
  return std::sqrt(2 * area / (std::numbers::sqrt3 * static_cast<double>(count)));
}

double even_count(double area, double spacing) {
  return std::max(1.0, std::round(2 * area / (std::numbers::sqrt3 * spacing * spacing)));
}

std::int64_t max_splits(const Mesh& mesh, std::int64_t count) {
  return std::min<std::int64_t>(4 * (mesh.vertex_count() + count), kMaxSamplingVertices);
}

}  // namespace gvd
