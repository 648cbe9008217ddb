#pragma once

#include <vector>

#include "comparator.hpp"
#include "diffusion/diffusion.hpp"

namespace gvd::paper {

struct ComparatorOptions {
  DiffusionOptions diffusion;
  /// Whether to list the windows of each generator for itself too, which takes m times the time and the memory.
  bool unpruned_windows = true;
};

/// The library's methods first: exact, growth with circle fronts, growth with planar fronts, the paper's steps as
/// written. Then the comparators: exact windows with straight segments [27], the same unpruned, diffusion [8], RVD
/// [29], LRVD [28]. All use one thread.
std::vector<Comparator> list_comparators(const ComparatorOptions& options = {});

}  // namespace gvd::paper
