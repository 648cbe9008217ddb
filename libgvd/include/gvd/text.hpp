#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

// Numbers and quotations for messages, and functions that read bytes and numbers from texts. Nothing here depends on
// the locale.
namespace gvd {

/// A number with its noun for messages: "1 face" or "3 faces".
inline std::string counted(std::int64_t count, std::string_view singular, std::string_view plural) {
  std::string text = std::to_string(count);
  text += ' ';
  text += count == 1 ? singular : plural;
  return text;
}

/// "a, b and c", where `last` is "and".
template <class Words>
std::string join_words(const Words& words, std::string_view last) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 < words.size() ? ", " : ' ' + std::string(last) + ' ';
    text += words[i];
  }
  return text;
}

/// `text` with the capital letters of ASCII in lower case.
inline std::string to_lower(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return lower;
}

/// Length of the longest text that a message quotes in full, in bytes.
inline constexpr std::size_t kLongestQuote = 40;

/// Prepares a text from a file for a message: bytes that are not printable ASCII become `?`, and "..." replaces what
/// follows after `longest` bytes.
inline std::string printable(std::string_view text, std::size_t longest = kLongestQuote) {
  std::string shown(text.substr(0, longest));
  std::replace_if(
      shown.begin(), shown.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  if (text.size() > longest) shown += "...";
  return shown;
}

/// The same between single quotes.
inline std::string quoted(std::string_view text) { return '\'' + printable(text) + '\''; }

/// The number that the whole of `text` spells. Nothing if it is not a number, or one that T can't hold.
template <class T>
std::optional<T> parse_number(std::string_view text) {
  T value{};
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return error == std::errc{} && stop == end ? std::optional(value) : std::nullopt;
}

/// The program that compressed these bytes, by the mark at their start: "gzip", "zip", "bzip2", "xz" or "zstd". Empty
/// for any other bytes.
inline std::string_view find_compression(std::string_view bytes) {
  using Mark = std::pair<std::string_view, std::string_view>;
  constexpr std::array<Mark, 4> kMarks{{{"\x1f\x8b\x08", "gzip"},
                                        {"PK\x03\x04", "zip"},
                                        {"\xfd"
                                         "7zXZ",
                                         "xz"},
                                        {"\x28\xb5\x2f\xfd", "zstd"}}};
  for (const auto& [mark, program] : kMarks) {
    if (bytes.starts_with(mark)) return program;
  }
  const bool is_bzip2 = bytes.starts_with("BZh") && bytes.substr(3).find("1AY&SY") == 1;  // after a digit
  return is_bzip2 ? "bzip2" : "";
}

/// Parses a list of numbers that are separated by blanks, commas and line ends; # begins a comment. `name` is the name
/// of the file, for messages. Throws Error{unreadable_input}, with name and line, for anything that is not a number.
/// Cost: O(length).
std::vector<double> parse_numbers(std::string_view content, const std::string& name);

/// Reads all bytes of a stream up to its end. If reading fails, `in.bad()` is true afterwards.
///
/// Throws std::bad_alloc if memory runs out; a copy from stream to stream would mistake that for the end of the input.
/// `expected` is the number of bytes if it is known, otherwise 0. Cost: O(bytes).
inline std::string read_to_end(std::istream& in, std::size_t expected = 0) {
  std::string bytes;
  bytes.reserve(expected);
  std::array<char, 1 << 14> block{};
  while (in.read(block.data(), block.size()), in.gcount() > 0) {
    bytes.append(block.data(), static_cast<std::size_t>(in.gcount()));
  }
  return bytes;
}

}  // namespace gvd
