#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

namespace gvd {

/// Longest text that a message quotes in full, bytes.
inline constexpr std::size_t kLongestQuote = 40;

/// A text from a file for a message: printable ASCII, `?` for other bytes, and "..." for those after `longest`.
inline std::string printable(std::string_view text, std::size_t longest = kLongestQuote) {
  std::string shown(text.substr(0, longest));
  std::replace_if(
      shown.begin(), shown.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  if (text.size() > longest) shown += "...";
  return shown;
}

/// The same in quotes.
inline std::string quoted(std::string_view text) {
  std::string shown = printable(text);
  shown.insert(shown.begin(), '\'');
  shown += '\'';
  return shown;
}

}  // namespace gvd
