#pragma once

#include <string>
#include <vector>

#include "common/options/options.hpp"
#include "gvd/option_list.hpp"

// The options that commands share, described once. The fields must outlive the list.
namespace gvd::app {

void describe_input(OptionList& list, InputOptions& input);

/// The format of a list of generators in a file, behind the options that say where generators come from.
void describe_generators_format(OptionList& list, InputOptions& input);

/// The check of a diagram after the run.
void describe_verify(OptionList& list, ComputeOptions& compute);

/// Threads and memory.
void describe_resources(OptionList& list, ComputeOptions& compute);

/// The files of every command. `formats`: the extensions that `-o` takes, without their dots; `usual`: the one of
/// standard output.
void describe_output(OptionList& list, OutputOptions& output, const std::vector<std::string>& formats,
                     const std::string& usual);

/// The files of a diagram.
void describe_diagram_output(OptionList& list, OutputOptions& output);
/// --no-curves, for files that have bisectors.
void describe_no_curves(OptionList& list, OutputOptions& output);

/// A further file of a command, which is written beside those of -o.
void describe_target(OptionList& list, OutputOptions& output, const std::string& name, std::string& file,
                     const std::vector<std::string>& extensions, Spec spec);

/// A rule for an option that does nothing unless one of these formats is written. `reason`: why not, up to "write one
/// of them with {output}", with "{output}" for the option that chooses formats.
ValueRule format_rule(const OutputOptions& output, const std::string& option, const std::vector<std::string>& formats,
                      const std::string& reason);

}  // namespace gvd::app
