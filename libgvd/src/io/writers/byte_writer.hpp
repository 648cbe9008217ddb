#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <iterator>
#include <ostream>
#include <string_view>
#include <utility>

#include "gvd/error.hpp"

namespace gvd::io {

/// Buffers text and little-endian numbers for a stream. Numbers are printed in any locale, doubles with the digits that
/// bring the same double back.
class ByteWriter {
 public:
  explicit ByteWriter(std::ostream& out) : out_(out) {}

  void text(std::string_view bytes) {
    buffer_.append(bytes.data(), bytes.data() + bytes.size());
    write_if_full();
  }

  template <class... Args>
  void print(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(buffer_), format, std::forward<Args>(args)...);
    write_if_full();
  }

  template <class T>
  void binary(T value) {
    auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
    if constexpr (std::endian::native == std::endian::big) std::reverse(bytes.begin(), bytes.end());
    buffer_.append(bytes.data(), bytes.data() + bytes.size());
    write_if_full();
  }

  /// Writes what is left and checks the stream. To be called once, at the end. Throws Error{unwritable_output}.
  void finish() {
    write_buffer();
    if (!out_.flush()) fail();
  }

 private:
  static constexpr std::size_t kPieceBytes = std::size_t{1} << 16;

  void write_if_full() {
    if (buffer_.size() >= kPieceBytes) write_buffer();
  }

  void write_buffer() {
    if (!out_.write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()))) fail();
    buffer_.clear();
  }

  [[noreturn]] static void fail() {
    throw Error(ErrorCode::unwritable_output, "cannot write to the output stream; is it closed or full?");
  }

  std::ostream& out_;
  fmt::memory_buffer buffer_;
};

}  // namespace gvd::io
