#pragma once

#include <cstdint>
#include <iosfwd>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/lloyd.hpp"
#include "gvd/surface_point.hpp"
#include "lloyd/timer.hpp"

namespace gvd::app {

/// When the energy of each iteration was known, and the generators then. The library reads no clock.
class RelaxationTrace {
 public:
  /// To be called from LloydOptions::on_iteration. Iterations that count as one with those before are forgotten.
  void note(std::int64_t iterations, const std::vector<SurfacePoint>& generators);

  /// The generators after so many iterations; 0: at the start.
  const std::vector<SurfacePoint>& generators(std::size_t iterations) const { return generators_[iterations]; }

  /// A table in CSV: a row for the start, and one for each iteration. `method`: of the run's diagrams.
  /// Of two runs only the last column, the seconds since the relaxation began, differs.
  void write(std::ostream& out, const LloydResult& result, const Method& method) const;

 private:
  Timer timer_;
  // Of the start, and of each iteration.
  std::vector<double> seconds_;
  std::vector<std::vector<SurfacePoint>> generators_;
};

}  // namespace gvd::app
