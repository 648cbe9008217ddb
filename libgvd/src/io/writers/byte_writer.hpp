#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>

#include "gvd/diagram.hpp"
#include "gvd/error.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd::io {

// Writes buffered text and bytes, Base64, and pieces of JSON.

/// The bytes of a number, the lowest first on every machine.
template <class T>
std::array<char, sizeof(T)> little_endian(T value) {
  auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
  if constexpr (std::endian::native == std::endian::big) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

/// Buffers text and little-endian numbers for a stream. Numbers do not depend on the locale, and doubles have the
/// fewest digits that read back to the same double.
class ByteWriter {
 public:
  explicit ByteWriter(std::ostream& out) : out_(out) {}

  void append(const char* bytes, std::size_t count) {
    buffer_.append(bytes, bytes + count);
    write_if_full();
  }
  void text(std::string_view bytes) { append(bytes.data(), bytes.size()); }

  template <class... Args>
  void print(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(buffer_), format, std::forward<Args>(args)...);
    write_if_full();
  }

  template <class T>
  void binary(T value) {
    const auto bytes = little_endian(value);
    append(bytes.data(), bytes.size());
  }

  template <class T>
  void big_endian(T value) {
    auto bytes = little_endian(value);
    std::reverse(bytes.begin(), bytes.end());
    append(bytes.data(), bytes.size());
  }

  /// Writes three numbers as 32-bit floats.
  template <class Vector>
  void floats(const Vector& v) {
    for (int i = 0; i < 3; ++i) binary(static_cast<float>(v[i]));
  }
  /// Writes the rest of the buffer and checks the stream. Call it once, at the end. Throws Error{unwritable_output}.
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

/// Encodes bytes or little-endian numbers, one after the other, as Base64 with padding (RFC 4648). Passes the digits to
/// `append` of `Sink`, four at a time; std::string is such a sink.
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
    for (const char value_byte : little_endian(value)) byte(static_cast<unsigned char>(value_byte));
  }

  /// Writes the last group, padded. Call it once, at the end.
  void finish() {
    if (count_ > 0) put_group();
  }

 private:
  static constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

  void put_group() {
    const std::uint32_t group = group_ << 8 * (3 - count_);
    std::array<char, 4> quad{'=', '=', '=', '='};
    for (int i = 0; i <= count_; ++i) quad[i] = kDigits[group >> (18 - 6 * i) & 63];
    out_.append(quad.data(), quad.size());
    group_ = 0;
    count_ = 0;
  }

  Sink& out_;
  std::uint32_t group_ = 0;
  int count_ = 0;  ///< number of bytes in the group
};

/// Encodes all of `bytes` as Base64. Cost: O(n).
inline std::string encode_base64(std::string_view bytes) {
  std::string digits;
  digits.reserve((bytes.size() + 2) / 3 * 4);
  Base64Writer writer(digits);
  for (const char byte : bytes) writer.byte(static_cast<unsigned char>(byte));
  writer.finish();
  return digits;
}

/// The fewest digits that read back to the same double; null for infinity and NaN, which JSON does not have.
inline std::string json_number(double value) { return std::isfinite(value) ? fmt::format("{}", value) : "null"; }

/// Prints the members "face" and "bary", without braces.
inline void print_location(ByteWriter& out, const SurfacePoint& point) {
  out.print("\"face\":{},\"bary\":[{},{},{}]", point.face.value(), point.bary[0], point.bary[1], point.bary[2]);
}

/// Prints the members "face", "bary" and "position", without braces.
inline void print_point_members(ByteWriter& out, const SurfacePoint& point, const Vec3& position) {
  print_location(out, point);
  out.print(",\"position\":[{},{},{}]", json_number(position.x()), json_number(position.y()),
            json_number(position.z()));
}

inline void print_point(ByteWriter& out, const Mesh& mesh, const SurfacePoint& point) {
  out.text("{");
  print_point_members(out, point, position(mesh, point));
  out.text("}");
}

/// The text of an array before its first item, between items, and after its last one.
struct ArraySpacing {
  std::string_view first, between, last;
};

/// Prints an array, by default on one line. `print` prints one item.
template <class Items, class Print>
void print_array(ByteWriter& out, const Items& items, Print print, const ArraySpacing& spacing = {"", ",", ""}) {
  out.text("[");
  std::string_view before = spacing.first;
  for (const auto& item : items) {
    out.text(before);
    before = spacing.between;
    print(item);
  }
  if (std::size(items) > 0) out.text(spacing.last);
  out.text("]");
}

/// Prints an array of ids as numbers, with -1 for an invalid id.
template <class Ids>
void print_ids(ByteWriter& out, const Ids& ids) {
  print_array(out, ids, [&](auto id) { out.print("{}", id.value()); });
}

/// Prints an array with each item on a line of its own.
template <class Items, class Print>
void print_lines(ByteWriter& out, const Items& items, Print print) {
  print_array(out, items, print, {"\n  ", ",\n  ", "\n"});
}

// Members of the JSON documents that hold a diagram and something made from it: a segmentation, a cut mesh or a remesh.

/// Prints the diagram as `gvd-diagram/1` without its last brace, so that more members can follow. Cost: O(n) time, O(1)
/// memory.
void print_open_diagram(ByteWriter& out, const Mesh& mesh, const Diagram& diagram);

/// Prints `"vertices":[[x,y,z]],"faces":[[a,b,c]]`, with one element on each line.
void print_mesh_members(ByteWriter& out, const Mesh& mesh);

/// Prints an array of elements, each on a line of its own without indent.
template <class Items, class Print>
void print_rows(ByteWriter& out, const Items& items, Print print) {
  print_array(out, items, print, {"\n", ",\n", ""});
}

}  // namespace gvd::io
