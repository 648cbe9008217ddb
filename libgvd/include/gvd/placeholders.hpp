#pragma once

#include <functional>
#include <string>
#include <string_view>

// Names of options in texts for users. The library does not know how an option is spelled where its texts are read: on
// a command line, in Python or in JavaScript. So its texts name an option by a placeholder between two control
// characters, which whoever shows the text replaces:
//
//   \1max_snap\2                       --max-snap on a command line
//   \1method=exact\2                   --method exact
//   \1?refine=false|exact_count\2      those of these options that the user gave: --no-refine
//   \1+, or raise |max_added\2         advice, left out where the call has no such option: ", or raise --max-added"
//
// Messages also contain texts from users, such as names of files, which are shown as they are. These must not contain
// the two control characters: they are refused in names of files, and quotations replace them.
namespace gvd {

/// Makes the placeholder of an option, or of an option with a value.
std::string placeholder(std::string_view name, std::string_view value = {});

/// Whether a user's text contains one of the characters that begin and end placeholders.
bool has_placeholder_mark(std::string_view text);

/// How those who read a text spell options.
struct OptionSpelling {
  /// Spells one option. `value` is empty if the placeholder has none.
  std::function<std::string(std::string_view name, std::string_view value)> spell;
  /// Whether the option was given. If that is unknown, all options count as given.
  std::function<bool(std::string_view name)> is_given = [](std::string_view) { return true; };
  /// Whether whoever reads the text can give the option.
  std::function<bool(std::string_view name)> can_give = [](std::string_view) { return true; };
};

/// Replaces the placeholders in a text as `spelling` says.
std::string spell_options(std::string_view text, const OptionSpelling& spelling);

/// Replaces the placeholders in a text by plain names and values: "max_snap", "refine=false".
std::string spell_options(std::string_view text);

/// The name of the option whose placeholder a text begins with; empty if it begins with anything else.
std::string_view first_option(std::string_view text);

}  // namespace gvd
