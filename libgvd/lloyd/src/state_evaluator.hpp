#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "gvd/lloyd.hpp"
#include "gvd/mesh.hpp"
#include "state/relaxation_state.hpp"

namespace gvd {

/// Computes the states of a relaxation with the diagrams of one level of precision after the other.
class StateEvaluator {
 public:
  /// Begins at the first level. All have to outlive this.
  StateEvaluator(const Mesh& mesh, const LloydOptions& options, const GeneratorConstraints& constraints);

  bool is_first_level() const { return level_ == 0; }
  bool is_last_level() const { return level_ + 1 == levels_.size(); }
  /// Whether more than one level follows.
  bool is_early_level() const { return level_ + 2 < levels_.size(); }
  void raise_level() { ++level_; }
  /// Where more than one level follows, goes to the last but one.
  void skip_early_levels() {
    while (is_early_level()) raise_level();
  }
  const Precision& precision() const { return levels_[level_]; }

  /// The state with the cells of this level. `report` is called with the fraction of the work that is done.
  RelaxationState evaluate(const std::vector<SurfacePoint>& generators, const std::function<void(double)>& report);
  /// The number of states.
  std::int64_t diagrams() const { return diagrams_; }

 private:
  const Mesh& mesh_;
  const LloydOptions& options_;
  const GeneratorConstraints& constraints_;
  std::vector<Precision> levels_;
  std::size_t level_ = 0;
  std::int64_t diagrams_ = 0;
};

}  // namespace gvd
