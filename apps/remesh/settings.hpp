#pragma once

#include <cstdint>
#include <optional>

#include "common/command.hpp"
#include "common/options/options.hpp"
#include "gvd/remesh.hpp"

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

inline const Choices<Placement> kPlacements{
    {"generator", Placement::generator}, {"quadric", Placement::quadric}, {"fit", Placement::fit}};

/// Adds --target-edge and --error, which take the place of -n, and the options of relaxation and remesh. Parsing fills
/// `settings`, which must outlive `command`, and the shared options of the command.
void register_settings(Command& command, Settings& settings);

/// The iterations of a run's relaxation: those given, or the default for sampled generators and 0 for listed ones,
/// which stay where the user has put them.
std::int32_t relax_iterations(const Settings& settings, const GeneratorOptions& generators);

/// Where a run puts its vertices: as given, or fitted with sampled generators and at the generators with listed ones.
Placement placement_method(const Settings& settings, const GeneratorOptions& generators);

/// Throws Error{invalid_option} for an option that contradicts the outputs, or that does nothing.
void check_settings(const Options& options, const Settings& settings);

}  // namespace gvd::app
