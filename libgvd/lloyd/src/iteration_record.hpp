#pragma once

#include <vector>

#include "generator_moves.hpp"
#include "gvd/lloyd.hpp"

namespace gvd {

/// The energies of a relaxation, from the start on, and what each iteration did.
struct IterationRecord {
  double initial_energy = 0;
  std::vector<LloydIteration> iterations;
  std::vector<double> falls;  ///< of each iteration, as a fraction of the energy before it; merging keeps them

  /// Adds an iteration that took the energy from `before` to `after`.
  void add(const GeneratorMove& move, double before, double after, const Precision& precision);
  /// Whether the last `window` iterations lower the energy by at least this fraction each, on the average, or there are
  /// fewer.
  bool falls_by(double fraction, int window) const;
  /// Restates the energy of the last iteration, or of the start. Iterations that have not lowered the energy as it is
  /// measured now count as one with the iteration before them.
  void restate(double energy, const Precision& precision);
  /// Makes one iteration of all.
  void merge_all();

 private:
  void merge_last();
};

}  // namespace gvd
