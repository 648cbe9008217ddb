#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "common/options.hpp"

namespace gvd::app {

/// Adds the options that the three commands share; parsing fills `options`, which must outlive `cli`.
/// `output_formats`: see CommandInfo.
void register_options(CLI::App& cli, Options& options, const std::vector<std::string>& output_formats);

/// What no single option can check: exactly one source of generators, formats of `-` named, known extensions, distinct
/// targets, none of them a file that is read. Throws Error{invalid_option}, or Error{unwritable_output} where a
/// target's folder does not exist.
void check_options(const Options& options, const std::vector<std::string>& output_formats);

/// "3,17,99" as indices. Throws Error{invalid_option} that names the part that is no index.
std::vector<std::int64_t> parse_vertex_list(const std::string& text);

/// The extension of `path` in lower case, without its dot; empty where it has none.
std::string extension(const std::string& path);

}  // namespace gvd::app
