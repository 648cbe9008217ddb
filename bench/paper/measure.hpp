#pragma once

#include <string>
#include <vector>

#include "comparators.hpp"
#include "judge.hpp"

namespace gvd::paper {

/// What is measured on a mesh. Run i draws the generators at vertices with seed i.
struct Experiment {
  const Mesh& mesh;
  int generators = 1;
  int runs = 1;
  bool errors = false;  ///< whether E and the turning angle are computed, which takes most of the time
  bool memory = false;  ///< whether the peak of the heap is counted, in a run of its own
};

struct Statistic {
  double mean = 0;
  double deviation = 0;  ///< of the sample, 0 for one run
  double least = 0;
  double most = 0;
};

Statistic summarize(const std::vector<double>& values);

/// A method's figures over all runs.
struct Measurement {
  std::string method;
  double field_ms = 0;         ///< median
  double diagram_ms = 0;       ///< median
  double memory_kb = 0;        ///< largest heap of the first run, without the input; 0 if it is not counted
  Statistic error;             ///< E, square mesh units
  std::vector<double> errors;  ///< E of each run; empty without errors
  double turn_per_length = 0;  ///< mean, radians for each mesh unit
  double islands = 0;          ///< mean number of components of cells without their generator
  double open_ends = 0;        ///< mean number of ends that nothing continues
};

/// Means over all runs of E and of what else could be taken for it, square mesh units.
struct OtherMeasurement {
  std::string method;
  double error = 0;
  OtherErrors others;
};

std::vector<OtherMeasurement> measure_others(const Experiment& experiment, const std::vector<Comparator>& methods);

std::vector<Measurement> measure(const Experiment& experiment, const std::vector<Comparator>& methods);

}  // namespace gvd::paper
