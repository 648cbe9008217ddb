#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/options/options.hpp"
#include "gvd/text.hpp"

// Kinds of options that CLI11 lacks: numbers in any locale, names of values, flags that can be turned off.
namespace gvd::app {

/// The option whose number may be left out.
inline constexpr const char* kWeldOption = "--weld";

/// A closed range of accepted values, and its description for messages.
template <class T>
struct Range {
  T low;
  T high;
  std::string_view text;  ///< what is expected: "a number above 0"
};

inline constexpr Range<double> kPositive{std::numeric_limits<double>::min(), std::numeric_limits<double>::max(),
                                         "a finite number above 0"};
inline constexpr Range<double> kNotNegative{0, std::numeric_limits<double>::max(), "a finite number from 0 on"};
inline constexpr Range<std::int32_t> kCount{1, std::numeric_limits<std::int32_t>::max(),
                                            "a whole number from 1 to 2147483647"};
inline constexpr Range<std::uint64_t> kAnyWhole{0, std::numeric_limits<std::uint64_t>::max(),
                                                "a whole number from 0 to 2^64 - 1"};

/// The number that `text` spells, where it lies in `range`. A NaN lies in no range.
template <class T>
std::optional<T> parse_number_in(std::string_view text, const Range<T>& range) {
  const std::optional<T> value = parse_number<T>(text);
  return value && *value >= range.low && *value <= range.high ? value : std::nullopt;
}

/// Stores "500M" as bytes: a number, maybe with a fraction, and K, M, G or T for 1024 to the first to fourth, in
/// capital or small letters; nothing for bytes. "B" or "iB" may follow. From 1 byte to 2^60. Returns what is wrong with
/// the text; empty where nothing is.
std::string parse_size(std::string_view text, std::optional<std::int64_t>& bytes);

/// Stores a text of the user's. Returns what is wrong with it; empty where nothing is.
using StoreText = std::function<std::string(const std::string&)>;

/// Adds an option whose texts go to `store`. `type` stands for the value in --help. It also says what a TOML file may
/// give: N a whole number, NUMBER a number, SIZE both or a string, LIST a string or whole numbers, all others a string.
CLI::Option* add_parsed(CLI::App& app, const std::string& names, const std::string& type, const StoreText& store,
                        const std::string& description);

/// Adds a flag, which `--flag=false` turns off. A flag that is off is as good as not given: nothing excludes it.
CLI::Option* add_flag(CLI::App& app, const std::string& names, bool& target, const std::string& description);

/// Refuses an empty name. `kind`: what is to be named, for messages.
CLI::Validator not_empty(const std::string& kind);

/// Adds an option that names a file. `type`: "FILE", or with an extension.
CLI::Option* add_file(CLI::App& app, const std::string& names, std::string& target, const std::string& description,
                      const std::string& type = "FILE");

/// The extensions, without their dots, of the files that an option writes beside those of -o: of all commands, so that
/// none of them puts a table or a report in the place of a mesh. Throws std::out_of_range for any other option.
const std::vector<std::string>& side_extensions(const std::string& option);

/// Refuses names without one of the `side_extensions` of the option. Pipes, "-", /dev and /proc may have any name.
CLI::Validator has_side_extension(const std::string& option);

/// Adds an option that names a file which is written beside those of -o.
CLI::Option* add_side_output(CLI::App& app, const std::string& name, std::string& target,
                             const std::string& description);

/// Adds an option that takes one number in `range`. `Target` is T or std::optional<T>.
template <class T, class Target>
CLI::Option* add_number(CLI::App& app, const std::string& names, Target& target, const Range<T>& range,
                        const std::string& description) {
  const auto store = [&target, range](const std::string& text) {
    const std::optional<T> value = parse_number_in(text, range);
    if (value) target = *value;
    return value ? "" : fmt::format("'{}' is not {}", text, range.text);
  };
  return add_parsed(app, names, std::numeric_limits<T>::is_integer ? "N" : "NUMBER", store, description);
}

/// What is wrong with a name that is none of these, with the one that it may stand for.
std::string describe_unknown(const std::string& text, const std::vector<std::string>& names);

/// Adds an option that takes one of a few names. `Target` is T or std::optional<T>.
template <class T, class Target>
CLI::Option* add_choice(CLI::App& app, const std::string& names, Target& target, const Choices<T>& choices,
                        const std::string& description) {
  std::vector<std::string> listed;
  for (const auto& [name, value] : choices) listed.emplace_back(name);
  const auto store = [&target, choices, listed](const std::string& text) {
    const std::optional<T> value = value_in(choices, text);
    if (value) target = *value;
    return value ? "" : describe_unknown(text, listed);
  };
  return add_parsed(app, names, fmt::format("{}", fmt::join(listed, "|")), store, description);
}

}  // namespace gvd::app
