#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>

namespace gvd {

/// A number with its noun for messages: "1 face" or "3 faces".
inline std::string counted(std::int64_t count, const std::string& singular, const std::string& plural) {
  return fmt::format("{} {}", count, count == 1 ? singular : plural);
}

}  // namespace gvd
