#pragma once

#include <vector>

#include "comparator.hpp"

namespace gvd::paper {

struct LrvdOptions {
  int most_rounds = 100;  ///< sweeps, >= 0; 0 leaves the restricted Voronoi diagram as it is
};

/// The localized restricted Voronoi diagram: every cell is the component with its generator, and what lies in islands
/// is divided among the cells around.
///
/// Source: D.-M. Yan, G. Bao, X. Zhang, P. Wonka, Low-resolution remeshing using the localized restricted Voronoi
///   diagram, 2014: [28] in the paper, section 5.5.
/// A round clips the pieces of each island by the bisector planes between the cells that touch it, of which only
/// components with a generator count. Parts that still do not touch their own cell are islands of the next round.
/// `rounds`: the number of sweeps. An island that no cell touches stays, and is counted: it lies on a component of the
/// mesh without a generator. Generators may lie anywhere.
Comparison compute_lrvd(const Mesh& mesh, const std::vector<SurfacePoint>& generators, const LrvdOptions& options = {});

}  // namespace gvd::paper
