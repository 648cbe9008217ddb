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

/// Text and little-endian numbers for a stream, in large pieces. Numbers are printed without regard to the locale,
/// doubles with as many digits as bring them back.
class ByteWriter {
 public:
  explicit ByteWriter(std::ostream& out) : out_(out) {}

  void text(std::string_view bytes) {
    buffer_.append(bytes.data(), bytes.data() + bytes.size());
    spill();
  }

  template <class... Args>
  void print(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(buffer_), format, std::forward<Args>(args)...);
    spill();
  }

  template <class T>
  void binary(T value) {
    auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
    if constexpr (std::endian::native == std::endian::big) std::reverse(bytes.begin(), bytes.end());
    buffer_.append(bytes.data(), bytes.data() + bytes.size());
    spill();
  }

  /// Passes on what is left and checks the stream. Throws Error{unwritable_output}.
  void finish() {
    pass_on();
    if (!out_.flush()) fail();
  }

 private:
  static constexpr std::size_t kPieceBytes = std::size_t{1} << 16;

  void spill() {
    if (buffer_.size() >= kPieceBytes) pass_on();
  }

  void pass_on() {
    if (!out_.write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()))) fail();
    buffer_.clear();
  }

  [[noreturn]] static void fail() {
    throw Error(ErrorCode::unwritable_output,
                "cannot write to the output stream: is it still open, and is there space?");
  }

  std::ostream& out_;
  fmt::memory_buffer buffer_;
};

}  // namespace gvd::io
