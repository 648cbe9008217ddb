#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace gvd {

/// A file may expand to at most kMostExpansion times its size, plus kFreeExpansion bytes, when it is read.
///
/// Real meshes are far below this: gzip compresses them 1.7 to 3.5 times, and a flat grid in binary STL 12 times.
/// Deflate can compress 1032 times, and a file that refers to the same array a thousand times has no limit at all.
inline constexpr std::uint64_t kMostExpansion = 200, kFreeExpansion = 1 << 20;

/// Counts the bytes that a file expands to, so that memory is bounded by the file's size.
class ExpansionLimit {
 public:
  /// `free`: how many bytes even the smallest file may expand to.
  ExpansionLimit(std::size_t file_bytes, std::string_view name, std::uint64_t free = kFreeExpansion)
      : left_(kMostExpansion * file_bytes + free), name_(name) {}

  /// Counts bytes. Throws Error{unreadable_input} if they exceed the limit.
  void spend(std::uint64_t bytes);
  /// Raises the limit by the size of another file that belongs to the first.
  void add_file(std::size_t file_bytes) { left_ += kMostExpansion * file_bytes; }

 private:
  std::uint64_t left_;
  std::string name_;
};

/// Unpacks the bytes of a gzip file, and decodes text in UTF-16; leaves other bytes unchanged.
void unpack(std::string& bytes, std::string_view name);

/// Whether the file begins like a gzip file. A binary STL that begins in the same way does not count.
bool is_gzip(std::string_view bytes);

/// Returns the content of all members of a gzip file. Throws Error{unreadable_input} if the file is truncated or
/// damaged, or exceeds ExpansionLimit. Cost: O(bytes of the content).
std::string unpack_gzip(std::string_view bytes, std::string_view name);

/// Whether a file is text in UTF-16, by its byte order mark. A binary STL that begins in the same way does not count.
bool is_utf16(std::string_view bytes);

/// Converts UTF-16 with a byte order mark to UTF-8 without one. Invalid characters become U+FFFD. Cost: O(bytes).
std::string to_utf8(std::string_view utf16);

/// Names the content of a file that is no mesh, and says what to do about it: "an HTML page; ...". Empty if the content
/// is not recognised. Cost: O(1); O(bytes) for JSON.
std::string describe_content(std::string_view bytes);

}  // namespace gvd
