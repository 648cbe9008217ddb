#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace gvd::io {

/// Base64 of RFC 4648, with padding, of bytes that come one by one or as little-endian numbers. `Sink` has
/// `text(std::string_view)`, which takes the digits in fours.
template <class Sink>
class Base64Writer {
 public:
  explicit Base64Writer(Sink& out) : out_(out) {}

  void byte(unsigned char value) {
    group_ = group_ << 8 | value;
    if (++count_ == 3) put_group();
  }

  template <class T>
  void binary(T value) {
    auto bytes = std::bit_cast<std::array<unsigned char, sizeof(T)>>(value);
    if constexpr (std::endian::native == std::endian::big) std::reverse(bytes.begin(), bytes.end());
    for (const unsigned char value_byte : bytes) byte(value_byte);
  }

  /// Writes what is left, padded. To be called once, at the end.
  void finish() {
    if (count_ > 0) put_group();
  }

 private:
  static constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

  void put_group() {
    const std::uint32_t group = group_ << 8 * (3 - count_);
    std::array<char, 4> quad{'=', '=', '=', '='};
    for (int i = 0; i <= count_; ++i) quad[i] = kDigits[group >> (18 - 6 * i) & 63];
    out_.text({quad.data(), quad.size()});
    group_ = 0;
    count_ = 0;
  }

  Sink& out_;
  std::uint32_t group_ = 0;
  int count_ = 0;  ///< bytes in the group
};

/// The whole of `bytes` in Base64. Cost: O(n).
std::string encode_base64(std::string_view bytes);

}  // namespace gvd::io
