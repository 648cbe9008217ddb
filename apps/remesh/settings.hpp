#pragma once

#include <cstdint>
#include <optional>

#include "common/command.hpp"
#include "common/options/options.hpp"
#include "gvd/remesh_surface.hpp"

namespace gvd::app {

/// The options of gvd-remesh alone.
struct Settings {
  RemeshOptions remesh;
  std::optional<std::int32_t> relaxation;  ///< iterations as given, >= 0; 0 is "none", no value the default
  ConstraintOptions constraints;
  bool loose_boundary = false;     ///< no generator is put on the boundary, unless it is sampled there
  std::optional<Placement> place;  ///< as given
  std::optional<double> shape;     ///< as given, in [0, 1]
  bool no_refine = false;
  bool exact_count = false;
  bool carry = false;
};

/// Adds --target-edge and --error, which take the place of -n, and the options of relaxation and remesh. Parsing fills
/// `settings`, which must outlive `command`, and the shared options of the command.
void register_settings(Command& command, Settings& settings);

/// Throws Error{invalid_option} for an option that contradicts the outputs, or that does nothing.
void check_settings(const Options& options, const Settings& settings);

}  // namespace gvd::app
