#pragma once

#include <optional>
#include <string>

#include "common/options/options.hpp"
#include "common/run/run.hpp"
#include "gvd/lloyd.hpp"
#include "gvd/mesh.hpp"

// What gvd-lloyd notes and reports: the report's `results` and `generators`, and its own options.
namespace gvd::app {

/// The command's own options.
struct OwnOptions {
  LloydOptions relaxation;
  ConstraintOptions constraints;
  std::optional<double> time_limit;  ///< of the relaxation, seconds, >= 0
};

/// The values of --accelerate, which the report gives for each iteration too.
const Choices<Acceleration>& acceleration_names();

void report_lloyd_options(Run& run, const OwnOptions& own);

/// The iterations, why they ended, and the generators that the run leaves, in place of those that it started from.
void report_relaxation(Run& run, const Mesh& mesh, const LloydResult& result);

/// What the energy of an iteration was measured with: the name of a method, or `sampled` without a diagram.
const char* measure_name(const LloydIteration& iteration);

/// How the step of an iteration was found, in one word.
std::string step_name(const LloydIteration& iteration);

}  // namespace gvd::app
