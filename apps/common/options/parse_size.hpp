#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace gvd::app {

/// A size, or what is wrong with its text.
struct ParsedSize {
  std::int64_t bytes = 0;
  std::string wrong;  ///< empty where nothing is
};

/// "500M" as bytes: a number, maybe with a fraction, and K, M, G or T for 1024 to the first to fourth, in capital or
/// small letters; nothing for bytes. "B" or "iB" may follow. From 1 byte to 2^60.
ParsedSize parse_size(std::string_view text);

}  // namespace gvd::app
