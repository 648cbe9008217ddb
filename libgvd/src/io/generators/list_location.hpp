#pragma once

#include <cstdint>
#include <string>

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

}  // namespace gvd::detail
