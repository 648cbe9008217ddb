#include "io/generators/list_location.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gvd/error.hpp"

namespace gvd::detail {
namespace {

/// Longest text that a message quotes in full.
constexpr std::size_t kQuoteLength = 40;

}  // namespace

std::string ListLocation::text() const { return line > 0 ? fmt::format("{}:{}", name, line) : name; }

void ListLocation::refuse(const std::string& message) const {
  throw Error(ErrorCode::unreadable_input, text() + ": " + message, line > 0 ? line - 1 : -1);
}

std::string printable(std::string_view text, std::size_t longest) {
  std::string shown(text.substr(0, longest));
  std::replace_if(
      shown.begin(), shown.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return text.size() > longest ? shown + "..." : shown;
}

std::string quoted(std::string_view text) { return fmt::format("'{}'", printable(text, kQuoteLength)); }

}  // namespace gvd::detail
