#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

#include "optimiser.hpp"
#include "relaxation_state.hpp"
#include "support/meshes.hpp"

namespace gvd::test {

/// The state of these generators with their exact diagram.
inline RelaxationState evaluate_state(const Mesh& mesh, const std::vector<SurfacePoint>& generators) {
  return evaluate_generators(mesh, generators, {});
}

/// A grid whose inner vertices are raised and lowered at random.
inline Mesh make_rough_grid(int size, double height, unsigned seed) {
  const Mesh grid = make_grid(size, size);
  std::mt19937 random(seed);
  std::vector<Vec3> positions;
  std::vector<std::array<VertexId, 3>> faces;
  for (const VertexId v : grid.vertices()) {
    const double share = 2 * double(random()) / double(std::mt19937::max()) - 1;
    positions.push_back(grid.position(v) + Vec3(0, 0, height * share));
  }
  for (const FaceId f : grid.faces()) faces.push_back(grid.vertices(f));
  return Mesh(std::move(positions), std::move(faces));
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
