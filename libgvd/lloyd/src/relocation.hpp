#pragma once

#include <cstddef>
#include <vector>

#include "generator_moves.hpp"
#include "gvd/density.hpp"
#include "gvd/mesh.hpp"
#include "relaxation_state.hpp"

namespace gvd {

/// A generator that leaves its place for another one.
struct Relocation {
  std::size_t generator;
  SurfacePoint to;
  double gain = 0;  ///< estimate of the energy that is saved, mesh units to the fourth
};

/// Moves from where cells are worth little to where they cost much, the most valuable first.
///
/// In the best diagrams all cells have about the same area and energy. Generators of cells with little energy go to the
/// vertex that is farthest from all generators, one after the other: farthest-point sampling, in straight distances
/// from those that came before. Cells that are given up together have at most half of the mean area of their
/// component wherever they adjoin, so that no holes arise. Every generator stays in its component of the mesh, and
/// those that are not free stay where they are.
/// Cost: O(n + m log m) for n vertices and m generators, and, for each vertex at places that were taken, the comparison
/// with those taken before it.
std::vector<Relocation> plan_relocations(const Mesh& mesh, const Density& density, const RelaxationState& state,
                                         const GeneratorConstraints& constraints = {});

/// The sum of the estimates.
double total_gain(const std::vector<Relocation>& relocations);

/// The move of the first `count` relocations. Lengths are straight through space.
GeneratorMove relocate_generators(const Mesh& mesh, const RelaxationState& state,
                                  const std::vector<Relocation>& relocations, std::size_t count);

}  // namespace gvd
