#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace gvd::app {

/// The number that `text` spells in full, in any locale; nothing where it spells none or T can't hold it.
template <class T>
std::optional<T> parse_number(std::string_view text) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

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
inline constexpr Range<std::int32_t> kCount{1, std::numeric_limits<std::int32_t>::max(), "a whole number from 1 on"};
inline constexpr Range<std::uint64_t> kAnyWhole{0, std::numeric_limits<std::uint64_t>::max(),
                                                "a whole number from 0 to 2^64 - 1"};

/// Adds an option that takes one number in `range`. Unlike CLI11's own conversion, it depends on no locale and takes
/// "010" for ten. `Target` is T or std::optional<T>.
template <class T, class Target>
CLI::Option* add_number(CLI::App& cli, const std::string& names, Target& target, Range<T> range,
                        const std::string& description) {
  const auto store = [&target, range, names](const std::string& text) {
    const std::optional<T> value = parse_number<T>(text);
    if (!value || !(*value >= range.low && *value <= range.high)) {
      throw CLI::ValidationError(names, fmt::format("'{}' is not {}", text, range.text));
    }
    target = *value;
  };
  return cli.add_option_function<std::string>(names, store, description)
      ->type_name(std::numeric_limits<T>::is_integer ? "N" : "NUMBER");
}

}  // namespace gvd::app
