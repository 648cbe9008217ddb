#pragma once

#include <cstddef>
#include <deque>

#include "tangent_field.hpp"

namespace gvd {

/// A step of all generators, and how much a field of tangent vectors changed by it.
struct StepPair {
  TangentField step;    ///< mesh units
  TangentField change;  ///< of the gradient (L-BFGS) or of the way to the centroid (Anderson)
};

/// The latest steps, oldest first. All vectors lie in the tangent planes at the present generators: `transport` takes
/// them along when the generators move.
class StepHistory {
 public:
  explicit StepHistory(std::size_t memory) : memory_(memory) {}

  /// Adds a pair, given at the present generators, and drops the oldest one beyond the memory.
  void add(StepPair pair) {
    pairs_.push_back(std::move(pair));
    if (pairs_.size() > memory_) pairs_.pop_front();
  }
  /// Parallel transport of all vectors: `turns` are those of the tangent planes along the generators' paths.
  void transport(const std::vector<Turn>& turns) {
    for (StepPair& pair : pairs_) {
      pair.step = turned(turns, std::move(pair.step));
      pair.change = turned(turns, std::move(pair.change));
    }
  }
  void clear() { pairs_.clear(); }
  const std::deque<StepPair>& pairs() const { return pairs_; }

 private:
  std::size_t memory_;
  std::deque<StepPair> pairs_;
};

}  // namespace gvd
