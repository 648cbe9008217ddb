#include "common/options/parse_size.hpp"

#include <cmath>
#include <string>

#include "common/options/parse_number.hpp"

namespace gvd::app {

std::optional<std::int64_t> parse_size(std::string_view text) {
  constexpr std::string_view kUnits = "kmgt";
  std::string lower(text);
  for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  double factor = 1;
  if (lower.ends_with('b')) lower.pop_back();
  const bool binary = lower.ends_with('i');
  if (binary) lower.pop_back();
  const std::size_t unit = lower.empty() ? kUnits.npos : kUnits.find(lower.back());
  if (unit != kUnits.npos) {
    factor = std::ldexp(1.0, 10 * (static_cast<int>(unit) + 1));
    lower.pop_back();
  } else if (binary) {
    return std::nullopt;
  }
  const auto number = parse_number_in(lower, kPositive);
  const double bytes = number.value_or(0) * factor;
  // Beyond 2^60 there is no such memory, and rounding begins.
  return bytes >= 1 && bytes <= 0x1p60 ? std::optional(static_cast<std::int64_t>(bytes)) : std::nullopt;
}

}  // namespace gvd::app
