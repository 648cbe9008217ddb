#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/options/command_line.hpp"
#include "common/options/options.hpp"

namespace gvd::app {

/// Adds the options that the three commands share. Parsing fills `options`, which must outlive `line`.
/// `output_formats`, `sizes`: see CommandInfo.
void register_options(CommandLine& line, Options& options, const std::vector<std::string>& output_formats,
                      bool sizes = false);

/// "3,17,99" as indices. Throws Error{invalid_option} that names the field that is no index.
std::vector<std::int64_t> parse_vertex_list(const std::string& text);

}  // namespace gvd::app
