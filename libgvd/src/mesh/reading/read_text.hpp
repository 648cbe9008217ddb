#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "gvd/vec.hpp"

namespace gvd {

/// The double nearest to a decimal number, the same in any locale: "1", "+1.5", "-2e-3", "nan", "inf". A number that is
/// too small for a double is 0, one that is too large is infinity. None where the token is anything else.
std::optional<double> parse_double(std::string_view token);

/// A decimal integer with an optional sign; none where the token is anything else or beyond 64 bits.
std::optional<std::int64_t> parse_integer(std::string_view token);

/// Reads a text line by line and token by token, and keeps the line number for messages.
class TextReader {
 public:
  /// Lines end in LF, CR LF or CR. With `comments`, the rest of a line from '#' on is skipped.
  TextReader(std::string_view bytes, std::string_view name, bool comments);
  TextReader(const TextReader&) = delete;
  TextReader& operator=(const TextReader&) = delete;

  /// Moves to the next line, or to the next line with a token. False at the end of the text.
  bool next_line();
  bool next_content_line();
  /// Moves to the next line with a token, where an element begins. Its numbers may continue on the next lines. False at
  /// the end of the text.
  bool begin_element();
  /// Refuses an element that continued on another line and does not end with that line: a number was missing, and the
  /// next element's numbers were read instead. `kind` and `element` are for messages.
  void end_element(std::string_view kind, std::int64_t element) const;
  /// The next token of the line; empty at its end.
  std::string_view token();
  /// Numbers the next lines as if `count` more lines came before them.
  void skip_line_numbers(std::int64_t count) { line_number_ += count; }

  /// The next token of the line, or of the element that has begun, as a number. Throws Error{unreadable_input} where it
  /// is missing or no number. `what` names it in the message.
  double number(std::string_view what);
  std::int64_t integer(std::string_view what);
  /// Three coordinates. Throws Error{precondition} where one is not finite. `vertex` is for messages.
  Vec3 position(std::int64_t vertex);

  std::string_view line() const { return line_; }
  /// Characters that are not read yet.
  std::size_t remaining() const { return text_.size(); }
  std::int64_t line_number() const { return line_number_; }
  /// Replaces the rest of the current line by another text, which must outlive its use.
  void replace_line(std::string_view line) { line_ = line; }

  /// Throws Error{unreadable_input}: "name:line: message".
  [[noreturn]] void refuse(const std::string& message, std::int64_t element = -1) const;
  /// Throws Error{unreadable_input} about the end of the file.
  [[noreturn]] void refuse_end(const std::string& message, std::int64_t element = -1) const;

 private:
  std::string_view next_number(std::string_view what);

  std::string unix_text_;  // a copy with LF for CR, if the text has lines that end in CR
  std::string_view text_;  // what is left after the current line
  std::string_view line_;  // what is left of the current line
  std::string name_;
  bool comments_;
  std::int64_t line_number_ = 0;
  std::int64_t element_line_ = 0;  // where the element begins; 0 outside of elements
};

}  // namespace gvd
