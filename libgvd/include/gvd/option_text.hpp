#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gvd/option_list.hpp"

// Values of options as texts: reading them, saying what is expected, and showing them. Everything is the same in any
// locale.
namespace gvd {

/// Stores the texts that were given for an option in its field, in their order. There are none if its name stands
/// alone. Returns what is wrong with the first wrong text, or an empty text; the texts before it are stored
/// nevertheless.
std::string read_option(const Option& option, const std::vector<std::string>& texts);

/// The placeholder of an option's value, as help shows it: "N", "FILE.csv", "exact|gbgvd|paper"; empty for a flag.
std::string value_name(const Field& field);

/// Says what a number has to be: "a whole number from 1 to 4096", "a finite number above 0 or 'none'".
std::string describe_range(const Number& number);

/// The text that would store the field's present value, or several texts for a list; nothing if the field has no value.
std::optional<std::vector<std::string>> write_option(const Field& field);

/// Whether a number may have a fraction.
bool is_real(const Number& number);

/// Whether a value may follow the name, and whether the name may stand alone. A flag stands alone.
bool takes_value(const Field& field);
bool stands_alone(const Field& field);
/// Whether an option may be given several times.
bool is_repeatable(const Field& field);

/// The boolean that a word of a command line means: true, on, yes, 1 and their opposites. Nothing for any other text.
std::optional<bool> parse_flag(const std::string& text);

/// The angle of "creases", which stands for `usual` degrees, or of "creases:ANGLE"; nothing for any other text.
std::optional<double> parse_creases(const std::string& text, double usual);

/// Prepares a user's text for a message: control characters become blanks, and "..." replaces what follows after
/// `longest` bytes. Characters of UTF-8 are not cut.
std::string user_text(std::string text, std::size_t longest = 60);

/// Says that a text is none of the names, and which of them it may stand for.
std::string describe_unknown(const std::string& text, const std::vector<std::string>& names);

/// The name that `wrong` most likely stands for, or nothing. Leading dashes, a value after "=", and upper or lower case
/// don't count.
///
/// This is the same name or, if `wrong` has three letters (one is enough for "INPUT"), the shortest name whose words
/// begin with those of `wrong`: "--output-dir" for "--out-d" or "--outdir". Otherwise it is the name that takes the
/// fewest insertions, deletions, replacements and swaps of neighbours, if these are at most one for each three letters
/// of `wrong`, or one in all. The first of equally good names is taken. Cost: O(letters) for each letter of each name.
std::optional<std::string> suggest_name(const std::string& wrong, const std::vector<std::string>& names);

/// The value of a field as help shows it for the default; empty if there is none, and for flags.
std::string default_text(const Field& field);

}  // namespace gvd
