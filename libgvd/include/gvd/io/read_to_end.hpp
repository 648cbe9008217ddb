#pragma once

#include <array>
#include <istream>
#include <string>

namespace gvd {

/// All bytes of a stream from here to its end. Where reading fails, `in.bad()` holds afterwards.
///
/// Throws std::bad_alloc where memory ends. A copy from stream to stream would take that for the end of the input.
/// Cost: O(bytes).
inline std::string read_to_end(std::istream& in) {
  std::string bytes;
  std::array<char, 1 << 14> block{};
  while (in.read(block.data(), block.size()), in.gcount() > 0) {
    bytes.append(block.data(), static_cast<std::size_t>(in.gcount()));
  }
  return bytes;
}

}  // namespace gvd
