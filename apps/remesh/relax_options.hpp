#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>

#include "common/options/options.hpp"

namespace gvd::app {

/// Iterations of the relaxation of sampled generators. On nine models with 2000 generators, the mean Q is .762 without
/// any, .902 after 10 and .919 after 20. After 30 it is at most .01 more.
inline constexpr std::int32_t kDefaultRelaxation = 15;

/// How gvd-remesh moves generators before it takes their dual.
struct RelaxOptions {
  std::optional<std::int32_t> iterations;  ///< as given, >= 0; 0 is "none", no value the default (relax_iterations)
  ConstraintOptions constraints;
  bool loose_boundary = false;  ///< no generator is put on the boundary, unless it is sampled there
};

/// Registers `--relax`, the options of constraints and `--loose-boundary`. `options` must outlive `app`.
void register_relaxation(CLI::App& app, RelaxOptions& options);

/// The iterations of a run: those given, or kDefaultRelaxation for sampled generators and 0 for listed ones, which
/// stay where the user has put them.
std::int32_t relax_iterations(const RelaxOptions& options, const GeneratorOptions& generators);

/// Throws Error{invalid_option} for an option that does nothing because no generator is relaxed.
void check_relaxation(const RelaxOptions& options, const GeneratorOptions& generators);

}  // namespace gvd::app
