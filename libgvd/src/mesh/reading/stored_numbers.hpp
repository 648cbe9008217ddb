#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace gvd {

/// How a binary file stores a number.
struct StoredNumber {
  enum class Kind { signed_integer, unsigned_integer, real };

  Kind kind = Kind::real;
  std::size_t size = 4;  ///< in bytes: 1, 2, 4 or 8; 4 or 8 for a real number
  bool big_endian = false;

  /// The bits of the number that begins at `bytes`.
  std::uint64_t read_bits(const char* bytes) const {
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < size; ++i) bits = bits << 8 | std::uint8_t(bytes[big_endian ? i : size - 1 - i]);
    return bits;
  }

  /// The number that begins at `bytes`. Integers beyond 2^53 are rounded.
  double read(const char* bytes) const {
    const std::uint64_t bits = read_bits(bytes);
    if (kind == Kind::real) return size == 8 ? std::bit_cast<double>(bits) : std::bit_cast<float>(std::uint32_t(bits));
    const std::size_t unused = 64 - 8 * size;
    return kind == Kind::signed_integer ? double(std::int64_t(bits << unused) >> unused) : double(bits);
  }

  /// All numbers of `bytes`; a remainder too short for a number is ignored.
  std::vector<double> read_all(std::string_view bytes) const {
    std::vector<double> numbers(bytes.size() / size);
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = read(bytes.data() + i * size);
    return numbers;
  }
};

}  // namespace gvd
