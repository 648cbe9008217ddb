#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace gvd {

/// A number with its noun for messages: "1 face" or "3 faces".
inline std::string counted(std::int64_t count, std::string_view singular, std::string_view plural) {
  std::string text = std::to_string(count);
  text += ' ';
  text += count == 1 ? singular : plural;
  return text;
}

}  // namespace gvd
