#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace gvd {

/// Whether a text is UTF-16 by its byte order mark. UTF-32 has another one, which may begin in the same way.
inline bool has_utf16_mark(std::string_view bytes) {
  if (bytes.starts_with(std::string_view("\xff\xfe\0\0", 4))) return false;
  return bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff");
}

/// Whether a text is UTF-16 that lacks its byte order mark: each of its first `characters` is one of ASCII and a zero,
/// which is always the first byte or always the second one.
inline bool is_unmarked_utf16(std::string_view bytes, std::size_t characters) {
  if (bytes.size() < 2 * characters) return false;
  const auto has_zeros = [&](std::size_t zero) {
    for (std::size_t at = 0; at < 2 * characters; at += 2) {
      const auto other = static_cast<std::uint8_t>(bytes[at + 1 - zero]);
      if (bytes[at + zero] != '\0' || other == 0 || other > 0x7F) return false;
    }
    return true;
  };
  return has_zeros(0) || has_zeros(1);
}

}  // namespace gvd
