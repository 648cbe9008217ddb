#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace gvd::detail {

/// A line of a list of generators, for messages. `name` must outlive it.
struct ListLocation {
  const std::string& name;  ///< of the file or option
  std::int32_t line = 0;    ///< 1-based; 0 where the list has no lines

  /// Throws Error{unreadable_input} with the location before the message.
  [[noreturn]] void refuse(const std::string& message) const;
  /// "name:line", or the name where there is no line.
  std::string text() const;
};

/// A text for a message: printable characters only, at most `longest` of them, and "..." where some are left out.
std::string printable(std::string_view text, std::size_t longest);

/// A field of a list between quotes, printable and short.
std::string quoted(std::string_view text);

}  // namespace gvd::detail
