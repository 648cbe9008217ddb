#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace gvd {

/// Whether a text begins with the byte order mark of UTF-16. One of the marks of UTF-32 begins in the same way, and
/// doesn't count.
inline bool has_utf16_mark(std::string_view bytes) {
  if (bytes.starts_with(std::string_view("\xff\xfe\0\0", 4))) return false;
  return bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff");
}

/// Whether a text is UTF-16 without a byte order mark: each of its first `characters` consists of an ASCII byte and a
/// zero byte, and the zero is always the first or always the second byte.
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
