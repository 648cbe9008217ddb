#pragma once

#include <charconv>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <system_error>

namespace gvd::app {

/// The number that `text` spells in full, in any locale. Nothing where it spells no number, or one that T can't hold.
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

}  // namespace gvd::app
