#pragma once

#include <functional>
#include <string>
#include <string_view>

// Names of options in texts for users. The library's texts don't know how an option is written where they are read, so
// they name it by a placeholder, which each reader spells in a way of its own:
//
//   {option:max_snap}                     --max-snap on a command line
//   {option:method=exact}                 --method exact
//   {given:refine=false|exact_count}      those of these options that the user gave: --no-refine
namespace gvd {

/// How a reader writes options.
struct OptionSpelling {
  /// `value` is empty where the placeholder has none.
  std::function<std::string(std::string_view name, std::string_view value)> spell;
  /// Where it is unknown what was given, everything counts as given.
  std::function<bool(std::string_view name)> is_given = [](std::string_view) { return true; };
};

/// The text with its placeholders as `spelling` writes them. What only looks like one stays.
std::string spell_options(std::string_view text, const OptionSpelling& spelling);

/// With the names and values themselves: "max_snap", "refine=false".
std::string spell_options(std::string_view text);

}  // namespace gvd
