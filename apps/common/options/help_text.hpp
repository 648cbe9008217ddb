#pragma once

#include <string>
#include <vector>

#include "common/options/option_text.hpp"

namespace gvd::app {

/// No line of a --help is longer, as long as no single word is.
inline constexpr std::size_t kHelpWidth = 80;

/// The words of `text` in lines of at most `width` columns, all but the first one after `indent` blanks.
std::string wrap(const std::string& text, std::size_t width, std::size_t indent);

/// The list of options in groups, in the order in which each group and each of its options comes first. Options without
/// a group are the last, under "General".
std::string describe_options(const std::vector<OptionText>& options);

}  // namespace gvd::app
