#include "precision_levels.hpp"

#include <algorithm>

namespace gvd {
namespace {

/// Least number of faces for each generator. With fewer, fast marching is not accurate enough to be worth its time.
constexpr std::size_t kLeastFaces = 20;

/// Chord tolerance of the last but one level, in mean edge lengths. A diagram takes 5 to 10 % less time than with 1e-4.
/// The energy rises with the square of the tolerance, for the true bisector is the best one.
constexpr double kCoarseChords = 0.05;

}  // namespace

std::vector<DiagramOptions> make_precision_levels(const Mesh& mesh, std::size_t generators,
                                                  const LloydOptions& options) {
  std::vector<DiagramOptions> levels;
  const bool approximate = options.early_approximation && max_iterations(options) > 0 &&
                           options.acceleration != Acceleration::none && options.diagram.method == Method::exact &&
                           static_cast<std::size_t>(mesh.face_count()) >= kLeastFaces * generators;
  if (approximate) {
    levels.assign(2, options.diagram);
    levels[0].method = Method::gbgvd;
    levels[0].front = Front::circle;
    levels[1].chord_tolerance = std::max(kCoarseChords, options.diagram.chord_tolerance);
  }
  levels.push_back(options.diagram);
  return levels;
}

}  // namespace gvd
