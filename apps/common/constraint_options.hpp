#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "common/options/command_line.hpp"

namespace gvd::app {

/// What restricts and weighs the relaxation.
struct ConstraintOptions {
  std::string fixed;               ///< a list of generators that stay; empty: none
  std::optional<double> features;  ///< angle of creases, degrees
  bool keep_boundary = false;
  /// Keep the boundary where generators are sampled, and enough of them are left beside it.
  bool prefers_boundary = false;
  std::string density;  ///< "curvature", a file, or a property of the input; empty: uniform
  double gradation = 0.3;
};

void register_constraints(CommandLine& line, ConstraintOptions& options);

}  // namespace gvd::app
