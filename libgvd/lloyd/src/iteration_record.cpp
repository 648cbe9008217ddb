#include "iteration_record.hpp"

#include <algorithm>
#include <numeric>

namespace gvd {

void IterationRecord::add(const GeneratorMove& move, double before, double after, const Precision& precision) {
  LloydIteration iteration;
  iteration.energy = after;
  for (const double length : move.length) {
    iteration.largest_move = std::max(iteration.largest_move, length);
    iteration.mean_move += length / static_cast<double>(move.length.size());
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

bool IterationRecord::falls_by(double fraction, std::size_t window) const {
  if (falls.size() < window) return true;
  const double sum = std::accumulate(falls.end() - static_cast<std::ptrdiff_t>(window), falls.end(), 0.0);
  return sum >= fraction * static_cast<double>(window);
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
