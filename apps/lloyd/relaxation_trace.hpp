#pragma once

#include <cstdint>
#include <iosfwd>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/lloyd.hpp"
#include "lloyd/timer.hpp"

namespace gvd::app {

/// When the energy of each iteration was known. The library reads no clock.
class RelaxationTrace {
 public:
  /// To be called from LloydOptions::on_iteration. Iterations that count as one with those before are forgotten.
  void note(std::int64_t iterations);

  /// A table in CSV: a row for the start, and one for each iteration. `method`: of the run's diagrams.
  /// Of two runs only the last column, the seconds since the relaxation began, differs.
  void write(std::ostream& out, const LloydResult& result, const Method& method) const;

 private:
  Timer timer_;
  std::vector<double> seconds_;  ///< of the start, and of each iteration
};

}  // namespace gvd::app
