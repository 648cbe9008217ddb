#pragma once

#include <string>
#include <vector>

#include "common/options/command_line.hpp"
#include "common/options/options.hpp"

namespace gvd::app {

/// Adds the options that the commands with diagrams share. Parsing fills `options`, which must outlive `app`.
/// `formats`: the extensions that `-o` takes, without their dots; the first one is that of standard output. Returns
/// the rules for their values.
std::vector<ValueRule> register_options(CLI::App& app, Options& options, const std::vector<std::string>& formats);

/// Adds the shared options of a command that measures distances between the points of lists: --from and --to in place
/// of generators, without those of diagrams. The rest as above.
std::vector<ValueRule> register_distance_options(CLI::App& app, Options& options,
                                                 const std::vector<std::string>& formats);

/// Adds the options that constrain and weigh a relaxation.
void register_constraints(CLI::App& app, ConstraintOptions& constraints);

/// Adds --coarse to the group of the options before it.
void register_coarse(CLI::App& app, ConstraintOptions& constraints);

/// Adds --help, --version, --config, -q and -v, which --help shows last.
void register_general(CLI::App& app, Options& options, const std::string& version);

}  // namespace gvd::app
