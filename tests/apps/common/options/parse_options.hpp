#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "common/options/check_options.hpp"
#include "common/options/command_line.hpp"
#include "common/options/options.hpp"

namespace gvd::test {

/// Formats that the commands of these tests write.
inline const std::vector<std::string> kFormats{"ply", "obj", "json"};

inline const app::OutputFormats kOutputFormats{kFormats};

/// Parses a command line without its first word. Returns the text of --help or --version, or nothing.
std::optional<std::string> parse_line(CLI::App& app, const std::vector<std::string>& arguments,
                                      const std::vector<app::ValueRule>& rules = {});

/// The shared options of a command line. Throws Error{invalid_option}.
app::Options parse_options(const std::vector<std::string>& arguments);

}  // namespace gvd::test
