#include "io/generators/list_location.hpp"

#include <fmt/format.h>

#include "gvd/error.hpp"

namespace gvd::detail {

std::string ListLocation::text() const { return line > 0 ? fmt::format("{}:{}", name, line) : name; }

void ListLocation::refuse(const std::string& message) const {
  throw Error(ErrorCode::unreadable_input, text() + ": " + message, line > 0 ? line - 1 : -1);
}

}  // namespace gvd::detail
