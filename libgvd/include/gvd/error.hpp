#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "gvd/placeholders.hpp"

namespace gvd {

/// Why an operation was refused. The set is closed: the commands map each code to an exit code.
enum class ErrorCode {
  invalid_option,     ///< an option or argument is out of its range (exit code 2)
  unreadable_input,   ///< a file is missing, is no mesh, or is damaged (exit code 3)
  precondition,       ///< the input can be read but breaks a stated precondition (exit code 4)
  no_valid_result,    ///< no valid result exists, or a stated guarantee is not met (exit code 5)
  unwritable_output,  ///< a file could not be written (exit code 6)
  reader_gone,        ///< the reader of the output has gone away, as `head` does (the signal SIGPIPE)
  interrupted,        ///< the caller's progress callback asked to stop (exit code 130)
};

/// The only exception that libgvd throws.
///
/// `what()` is one line without a trailing full stop or line break: what is wrong, where (file, line or
/// element), and what to do about it. It calls options by the names of their fields.
class Error : public std::runtime_error {
 public:
  /// `text` may name options by placeholders. `element` is the 0-based index of the first offending element, or -1 if
  /// there is none.
  Error(ErrorCode code, const std::string& text, std::int64_t element = -1)
      : std::runtime_error(spell_options(text)), code_(code), text_(text), element_(element) {}

  ErrorCode code() const noexcept { return code_; }
  std::int64_t element() const noexcept { return element_; }
  /// The same text with its placeholders, for callers that spell options in their own way.
  const char* text() const noexcept { return text_.what(); }

  /// The same error with a place in front of its text: "WHERE: TEXT".
  Error at(std::string_view where) const { return {code_, std::string(where) + ": " + text(), element_}; }

 private:
  ErrorCode code_;
  std::runtime_error text_;  // a runtime_error, because copying it can't throw
  std::int64_t element_;
};

/// A value, or the error that says why there is none. A function returns it if its caller can go on without the value.
template <class T>
using OrError = std::variant<T, Error>;

/// The value; throws the error if there is none.
template <class T>
T value_or_throw(OrError<T>&& outcome) {
  if (const Error* const error = std::get_if<Error>(&outcome)) throw *error;
  return std::get<T>(std::move(outcome));
}

}  // namespace gvd
