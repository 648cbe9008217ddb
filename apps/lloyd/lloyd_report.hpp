#pragma once

#include <chrono>
#include <optional>

#include "common/options/typed_options.hpp"
#include "common/run/run.hpp"
#include "gvd/lloyd.hpp"
#include "gvd/mesh.hpp"

// What gvd-lloyd notes and reports: the report's `results` and `generators`, and its own options.
namespace gvd::app {

/// The command's own options.
struct OwnOptions {
  LloydOptions relaxation;
  std::optional<double> time_limit;  ///< of the relaxation, seconds, >= 0
};

/// The time since it was made.
class Timer {
 public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// The values of --accelerate, which the report gives for each iteration too.
const Choices<Acceleration>& acceleration_names();

void report_lloyd_options(Run& run, const OwnOptions& own);

/// The iterations, why they ended, and the generators that the run leaves, in place of those that it started from.
void report_relaxation(Run& run, const Mesh& mesh, const LloydResult& result);

/// The reason of the end in one word, as reports and pages name it.
const char* name_of(LloydStop stop);

}  // namespace gvd::app
