#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/options/command_line.hpp"
#include "common/options/options.hpp"

namespace gvd::app {

/// Adds the options that the three commands share. Parsing fills `options`, which must outlive `app`.
/// `formats`: the extensions that `-o` takes, without their dots; the first one is that of standard output. Returns
/// the rules for their values.
std::vector<ValueRule> register_options(CLI::App& app, Options& options, const std::vector<std::string>& formats);

/// Adds --target-edge and --error, which take the place of -n.
void register_sizes(CLI::App& app, GeneratorOptions& generators);

/// Adds the options that constrain and weigh a relaxation.
void register_constraints(CLI::App& app, ConstraintOptions& constraints);

/// Adds --help, --version, --config, -q and -v, which --help shows last.
void register_general(CLI::App& app, Options& options, const std::string& version);

/// Reads "3,17,99" as indices and appends them. Returns what is wrong with the text; empty where nothing is.
std::string append_vertices(const std::string& text, std::vector<std::int64_t>& indices);

}  // namespace gvd::app
