#pragma once

#include <functional>
#include <string>
#include <string_view>

// Names of options in texts for users. The library's texts don't know how an option is written where they are read, so
// they name it by a placeholder between two control characters, which each reader spells in a way of its own:
//
//   \1max_snap\2                       --max-snap on a command line
//   \1method=exact\2                   --method exact
//   \1?refine=false|exact_count\2      those of these options that the user gave: --no-refine
//   \1+, or raise |max_added\2         advice, left out where the call has no such option: ", or raise --max-added"
//
// Texts of users, such as names of files, stand in the same messages and are shown as they are. So no text of a user's
// may have these two characters: doors refuse them in names of files, and quotations show other characters for them.
namespace gvd {

/// The placeholder of an option, and of a value for it.
std::string placeholder(std::string_view name, std::string_view value = {});

/// Whether a text of a user's has one of the characters that begin and end placeholders.
bool has_placeholder_mark(std::string_view text);

/// How a reader writes options.
struct OptionSpelling {
  /// `value` is empty where the placeholder has none.
  std::function<std::string(std::string_view name, std::string_view value)> spell;
  /// Where it is unknown what was given, everything counts as given.
  std::function<bool(std::string_view name)> is_given = [](std::string_view) { return true; };
  /// Whether whoever reads the text can give the option.
  std::function<bool(std::string_view name)> can_give = [](std::string_view) { return true; };
};

/// The text with its placeholders as `spelling` writes them.
std::string spell_options(std::string_view text, const OptionSpelling& spelling);

/// With the names and values themselves: "max_snap", "refine=false".
std::string spell_options(std::string_view text);

/// The option whose placeholder a text begins with; empty where it begins with none.
std::string_view first_option(std::string_view text);

}  // namespace gvd
