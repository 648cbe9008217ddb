#pragma once

#include <algorithm>
#include <numeric>
#include <optional>
#include <vector>

#include "generator_moves.hpp"

namespace gvd {

/// Records the energies of a relaxation from its start, and its iterations.
///
/// When the level of precision changes, the last energy is restated. Iterations that have not lowered the energy as it
/// is now measured are merged with the iteration before them, and their moves are added. So the energies still
/// decrease.
struct IterationRecord {
  double initial_energy = 0;
  std::vector<LloydIteration> iterations;
  /// The fall of the energy in each iteration, as a fraction of the energy before it. Merging does not change this
  /// list, because the rule that ends a level needs the mean.
  std::vector<double> falls;

  /// Adds an iteration that took the energy from `before` to `after`.
  void add(const GeneratorMove& move, double before, double after, const Precision& precision) {
    LloydIteration iteration;
    iteration.energy = after;
    for (const double length : move.length) {
      iteration.largest_move = std::max(iteration.largest_move, length);
      iteration.mean_move += length / double(move.length.size());
    }
    iteration.scale = move.scale;
    iteration.held = move.held;
    iteration.method = precision.diagram.method;
    iteration.is_sampled = precision.skips_diagram;
    iteration.by = move.by;
    iteration.relocated = move.relocated;
    iterations.push_back(iteration);
    falls.push_back((before - after) / before);
  }

  /// The sum of the falls of the last `window` iterations; nothing if there are fewer.
  std::optional<double> sum_falls(int window) const {
    if (std::ssize(falls) < window) return std::nullopt;
    return std::accumulate(falls.end() - window, falls.end(), 0.0);
  }

  /// The largest fall of the last `window` iterations, or of all; 0 if there are none.
  double largest_fall(std::ptrdiff_t window) const {
    return std::accumulate(falls.end() - std::min(window, std::ssize(falls)), falls.end(), 0.0,
                           [](double a, double b) { return std::max(a, b); });
  }

  /// Restates the energy of the last iteration, or of the start. Iterations that have not lowered the energy as it is
  /// now measured are merged with the iteration before them.
  void restate(double energy, const Precision& precision) {
    while (iterations.size() > 1 && !(energy < iterations[iterations.size() - 2].energy)) merge_last();
    if (iterations.empty()) {
      initial_energy = energy;
    } else {
      iterations.back().energy = energy;
      iterations.back().method = precision.diagram.method;
      iterations.back().is_sampled = precision.skips_diagram;
    }
  }

  /// Merges all iterations into one.
  void merge_all() {
    while (iterations.size() > 1) merge_last();
  }

 private:
  void merge_last() {
    const LloydIteration last = iterations.back();
    iterations.pop_back();
    iterations.back().largest_move += last.largest_move;
    iterations.back().mean_move += last.mean_move;
    iterations.back().relocated += last.relocated;
  }
};

}  // namespace gvd
