#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gvd/option_list.hpp"

// Values of options as texts: read, with what is expected, and shown. Everything is the same in any locale.
namespace gvd {

/// Stores the texts that were given for an option, in their order; none where its name stands alone. The field has what
/// is right up to the first text that is wrong. Returns what is wrong; empty where nothing is.
std::string read_option(const Option& option, const std::vector<std::string>& texts);

/// What an option takes, as help shows it: "N", "FILE.csv", "exact|gbgvd|paper"; empty for a flag.
std::string value_name(const Field& field);

/// What a number has to be: "a whole number from 1 to 4096", "a finite number above 0 or 'none'".
std::string describe_range(const Number& number);

/// The text that gives the value which the field has now; nothing where it has none. For a list, its parts.
std::optional<std::vector<std::string>> write_option(const Field& field);

/// Whether a number may have a fraction.
bool is_real(const Number& number);

/// Whether a value may follow the name, and whether the name may stand alone. A flag stands alone.
bool takes_value(const Field& field);
bool stands_alone(const Field& field);
/// Whether an option may be given several times.
bool is_repeatable(const Field& field);

/// Whether a boolean is meant, in the words of command lines: true, on, yes, 1 and their opposites. Nothing for others.
std::optional<bool> parse_flag(const std::string& text);

/// The angle that "creases", for `usual` degrees, or "creases:ANGLE" asks for; nothing where the text is neither.
std::optional<double> parse_creases(const std::string& text, double usual);

/// A text of the user's for a message: blanks for control characters, and "..." after `longest` bytes. Letters of UTF-8
/// stay whole.
std::string user_text(std::string text, std::size_t longest = 60);

/// Says that a name is none of these, and which one it may stand for.
std::string describe_unknown(const std::string& text, const std::vector<std::string>& names);

/// The name that `wrong` most likely stands for, or nothing. Dashes in front, a value behind "=", and capitals don't
/// count.
///
/// The same name, or the shortest one whose words begin with those of `wrong`, where that has three letters, or
/// one for "INPUT": "--out-d" or "--outdir" for "--output-dir". Else
/// the name that takes the fewest insertions, deletions, replacements and swaps of neighbours, if there is at most one
/// for each three letters of `wrong`, or one in all. The first of equals is taken. Cost: O(letters) for each letter of
/// each name.
std::optional<std::string> suggest_name(const std::string& wrong, const std::vector<std::string>& names);

/// The value of an option as its default in words; empty where it has none, and for flags.
std::string default_text(const Field& field);

}  // namespace gvd
