#pragma once

#include <cstdlib>

namespace gvd::test {

/// The number in a variable of the environment, or another one where it is not set.
inline unsigned number_from_environment(const char* variable, unsigned otherwise) {
  const char* text = std::getenv(variable);
  return text == nullptr ? otherwise : static_cast<unsigned>(std::strtoul(text, nullptr, 10));
}

}  // namespace gvd::test
