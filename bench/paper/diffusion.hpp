#pragma once

#include <vector>

#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"

namespace gvd::paper {

/// The heat that has spread from each generator after one implicit time step.
///
/// Source: K. Crane, C. Weischedel, M. Wardetzky, Geodesics in heat, 2013, its first step; P. Herholz, F. Haase, M.
///   Alexa, Diffusion diagrams, 2017. (M + t L) u = e with the lumped mass M and the cotangent Laplacian L; e is 1 at
///   the generator's vertex, so that every generator sends the same heat.
/// Heat falls like exp(-distance / sqrt(t)) and would underflow some 700 sqrt(t) away. It is scaled by kScale, the same
/// for all generators, which moves that to more than 1200 sqrt(t). Obtuse angles make negative values possible. What is
/// below kFloor is 0.
struct HeatField {
  static constexpr double kScale = 1e250, kFloor = 1e-290;

  std::vector<std::vector<double>> heat;  ///< [generator][vertex], >= 0, in units without meaning
};

/// One sparse factorisation, and one solution for each generator. `time`: square mesh units, > 0.
/// Throws Error{no_valid_result} if the factorisation fails. Cost: about O(n^1.5) for it, O(n log n) for each solution.
HeatField compute_heat(const Mesh& mesh, const std::vector<VertexId>& generators, double time);

}  // namespace gvd::paper
