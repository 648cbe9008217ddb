// The record of a relaxation's energies, which fall from one iteration to the next.
//
// A change of the level of precision restates the last energy. Iterations that have not lowered the energy as it is
// measured then count as one with the iteration before them, with the sum of their moves. So the energies still fall.
// The falls of single iterations are kept apart and never merged: the rule that ends a level asks for their mean.
#include <algorithm>
#include <numeric>

#include "generator_moves.hpp"

namespace gvd {

void IterationRecord::add(const GeneratorMove& move, double before, double after, const Precision& precision) {
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

bool IterationRecord::falls_by(double fraction, int window) const {
  if (std::ssize(falls) < window) return true;
  return std::accumulate(falls.end() - window, falls.end(), 0.0) >= fraction * window;
}

void IterationRecord::restate(double energy, const Precision& precision) {
  while (iterations.size() > 1 && !(energy < iterations[iterations.size() - 2].energy)) merge_last();
  if (iterations.empty()) {
    initial_energy = energy;
  } else {
    iterations.back().energy = energy;
    iterations.back().method = precision.diagram.method;
    iterations.back().is_sampled = precision.skips_diagram;
  }
}

void IterationRecord::merge_all() {
  while (iterations.size() > 1) merge_last();
}

void IterationRecord::merge_last() {
  const LloydIteration last = iterations.back();
  iterations.pop_back();
  iterations.back().largest_move += last.largest_move;
  iterations.back().mean_move += last.mean_move;
  iterations.back().relocated += last.relocated;
}

}  // namespace gvd
