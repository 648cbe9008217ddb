#pragma once

#include <vector>

#include "comparator.hpp"

namespace gvd::paper {

struct DiffusionOptions {
  /// Time step, in squared mean edge lengths, > 0. 1 is what [7] and [8] recommend; more is smoother.
  double time_factor = 1;
  /// How often a face may be split in four around points where several cells meet, 0 to 12.
  int most_splits = 5;
};

/// The diffusion diagram: the cell of a generator is where most heat comes from it.
///
/// Source: P. Herholz, F. Haase, M. Alexa, Diffusion diagrams: Voronoi cells and centroids from diffusion, 2017: [8] in
///   the paper, section 5.4.
/// `field_ms`: matrix, factorisation, and a solution for each generator; `diagram_ms`: labels and envelopes. Faults:
/// faces in which the cap ended the split, and vertices that no heat reaches (HeatField says when). Generators may lie
/// anywhere: they become vertices first. Throws Error{invalid_option} if an option is out of its range.
Comparison compute_diffusion(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                             const DiffusionOptions& options = {});

}  // namespace gvd::paper
