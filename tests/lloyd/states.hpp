#pragma once

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "optimiser.hpp"
#include "relaxation_state.hpp"

namespace gvd::test {

/// The state of these generators with their exact diagram.
inline RelaxationState evaluate_state(const Mesh& mesh, const std::vector<SurfacePoint>& generators) {
  return evaluate_generators(mesh, generators, {});
}

/// A field of tangent vectors with coordinates from -1 to 1.
inline TangentField random_field(std::size_t size, std::mt19937& random) {
  const auto real = [&] { return 2 * double(random()) / double(std::mt19937::max()) - 1; };
  TangentField field(size);
  for (Vec2& v : field) {
    v.x() = real();
    v.y() = real();
  }
  return field;
}

/// The length of all vectors together.
inline double length(const TangentField& field) { return std::sqrt(dot(field, field)); }

}  // namespace gvd::test
