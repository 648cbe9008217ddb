#include "precision_levels.hpp"

#include <algorithm>

namespace gvd {
namespace {

/// Chord tolerance of the last but one level, in mean edge lengths. A diagram takes 5 to 10 % less time than with 1e-4.
/// The energy rises with the square of the tolerance, for the true bisector is the best one.
constexpr double kCoarseChords = 0.05;

}  // namespace

std::vector<Precision> make_precision_levels(const LloydOptions& options) {
  std::vector<Precision> levels;
  const bool starts_without_diagrams = options.early_approximation && max_iterations(options) > 0 &&
                                       options.acceleration != Acceleration::none &&
                                       options.diagram.method == Method::exact;
  if (starts_without_diagrams) {
    levels.assign(2, {options.diagram, false});
    levels[0].skips_diagram = true;
    levels[1].diagram.chord_tolerance = std::max(kCoarseChords, options.diagram.chord_tolerance);
  }
  levels.push_back({options.diagram, false});
  return levels;
}

}  // namespace gvd
