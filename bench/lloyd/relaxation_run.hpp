#pragma once

// Energies are given as E = energy / (area^2 / m): a flat honeycomb has 0.16038 for any number m of generators.
#include <optional>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/lloyd.hpp"
#include "gvd/mesh.hpp"

namespace gvd::bench {

/// A flat open square of n x n unit squares, each cut in two triangles. n >= 1.
Mesh make_flat_square(int n);

struct InteriorEnergy {
  int cells = 0;
  double energy = 0;  ///< sum of the energies x cells / (sum of the areas)^2: 0.16038 for a honeycomb
};

/// Of the cells whose generators are at least `margin` cell widths, sqrt(area / cells), within make_flat_square(n).
/// Cells at the boundary cannot be hexagons, and shape their neighbours.
InteriorEnergy interior_energy(const Mesh& square, int n, const Diagram& diagram, double margin);

/// E of the cells of a diagram, with exact distances.
double scaled_energy(const Mesh& mesh, const Diagram& diagram);

/// E after an iteration, measured with the diagram that the relaxation had then: approximate in early iterations.
struct TracePoint {
  int iteration = 0;
  double seconds = 0;  ///< processor time since the beginning
  double energy = 0;   ///< E
};

struct RelaxationRun {
  LloydResult result;
  double seconds = 0;  ///< processor time, with the diagram of the result
  double energy = 0;   ///< E of the result, exact
  std::vector<TracePoint> trace;
};

/// Relaxes on this thread.
RelaxationRun run_relaxation(const Mesh& mesh, const std::vector<SurfacePoint>& generators, LloydOptions options,
                             const LloydStages& stages = {});

/// The run with the fewest iterations whose result has at most the energy E.
struct ShortestRun {
  int iterations = 0;
  double seconds = 0;  ///< median
  double energy = 0;   ///< E of its result, exact
};

/// Which iteration to end at is read from `trace` and then tried, as energies of early iterations are approximate.
/// Nothing if no run up to the end of the trace reaches that E. Times are medians of `runs` >= 1 runs.
std::optional<ShortestRun> shortest_run_to(double energy, const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                                           const std::vector<TracePoint>& trace, int runs);

}  // namespace gvd::bench
