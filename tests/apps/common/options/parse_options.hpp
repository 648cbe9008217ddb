#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/options/check_options.hpp"
#include "common/options/options.hpp"
#include "gvd/generator_options.hpp"
#include "gvd/option_list.hpp"

namespace gvd::test {

/// Formats that the commands of these tests write.
inline const std::vector<std::string> kFormats{"ply", "obj", "json"};

inline const app::OutputFormats kOutputFormats{kFormats};

/// The options of a command with diagrams.
struct SharedOptions : app::Options {
  GeneratorOptions generators;
  DiagramOptions diagram;
};

/// The shared options of a command with diagrams, and those that every command has.
struct SharedLine {
  SharedLine();
  /// Parses a command line without its first word. Returns the text of --help or --version, or nothing.
  /// Throws Error{invalid_option}.
  std::optional<std::string> parse(const std::vector<std::string>& arguments);

  SharedOptions options;
  OptionList list;
  Given given;
};

/// The shared options of a command line. Throws Error{invalid_option}.
SharedOptions parse_options(const std::vector<std::string>& arguments);

/// Parses a command line, and checks its options as a command does. Throws what check_inputs and check_outputs throw.
void check_line(const std::vector<std::string>& arguments, const app::OutputFormats& formats = kOutputFormats);

/// The same of a command that has further options.
void check_line(SharedLine& line, const std::vector<std::string>& arguments,
                const app::OutputFormats& formats = kOutputFormats);

}  // namespace gvd::test
