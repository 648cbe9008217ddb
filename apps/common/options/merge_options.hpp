#pragma once

#include <vector>

#include "common/options/option_text.hpp"

namespace gvd::app {

/// What holds of a command line and a file. The line overrides the file: of the file, an option is left out that
///
/// 1. the line gives too;
/// 2. excludes, or is excluded by, one of the line: a file's `n` goes where the line has --vertices;
/// 3. needs one that the line rules out: a file's `sampling` goes with its `n`.
std::vector<GivenOption> merge_options(const std::vector<GivenOption>& line, const std::vector<GivenOption>& file);

/// Refuses options that exclude each other, and options that do nothing without one that is missing.
/// Throws Error{invalid_option} that names both, and the place of those that come from a file.
void check_together(const std::vector<GivenOption>& given);

}  // namespace gvd::app
