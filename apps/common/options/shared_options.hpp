#pragma once

#include <string>
#include <vector>

#include "common/options/options.hpp"
#include "gvd/option_list.hpp"

// Describes the options that commands share. The fields must outlive the list.
namespace gvd::app {

void describe_input(OptionList& list, InputOptions& input);

/// Describes the format of a list of generators, after the options for the generators.
void describe_generators_format(OptionList& list, InputOptions& input);

/// Describes the check of a diagram after the run.
void describe_verify(OptionList& list, ComputeOptions& compute);

/// Describes the options for threads and memory.
void describe_resources(OptionList& list, ComputeOptions& compute);

/// Describes the output files of every command. `formats`: the extensions that `-o` takes, without their dots; `usual`:
/// the default format of standard output.
void describe_output(OptionList& list, OutputOptions& output, const std::vector<std::string>& formats,
                     const std::string& usual);

/// Describes the output files of a diagram.
void describe_diagram_output(OptionList& list, OutputOptions& output);
/// Describes --no-curves, for files with bisectors.
void describe_no_curves(OptionList& list, OutputOptions& output);

/// Describes a further output file of a command, beside the files of -o.
void describe_target(OptionList& list, OutputOptions& output, const std::string& name, std::string& file,
                     const std::vector<std::string>& extensions, Spec spec);

/// A rule for an option that has no effect unless one of these formats is written. `reason`: the reason, up to "write
/// one of them with {output}", where "{output}" stands for the option that chooses formats.
ValueRule format_rule(const OutputOptions& output, const std::string& option, const std::vector<std::string>& formats,
                      const std::string& reason);

}  // namespace gvd::app
