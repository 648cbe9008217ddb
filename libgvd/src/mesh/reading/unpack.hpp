#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace gvd {

/// The most bytes that a file may unfold to when it is read: kMostExpansion times its size, and kFreeExpansion.
///
/// gzip takes ten models to 1 : 1.7 to 3.5, and a flat grid of 180,000 triangles in binary STL to 1 : 12, the most that
/// we found. Deflate goes down to 1 : 1032, and a file that refers to one array a thousand times has no limit at all.
inline constexpr std::uint64_t kMostExpansion = 200, kFreeExpansion = 1 << 20;

/// Counts what a file unfolds to, so that memory is bounded by the file's size.
class ExpansionLimit {
 public:
  /// `free`: bytes that even the smallest file may unfold to.
  ExpansionLimit(std::size_t file_bytes, std::string_view name, std::uint64_t free = kFreeExpansion)
      : left_(kMostExpansion * file_bytes + free), name_(name) {}

  /// Throws Error{unreadable_input} where these bytes are too many.
  void spend(std::uint64_t bytes);
  /// Another file belongs to the first one.
  void add_file(std::size_t file_bytes) { left_ += kMostExpansion * file_bytes; }

 private:
  std::uint64_t left_;
  std::string name_;
};

/// Unpacks the bytes of a gzip file, and decodes text in UTF-16; leaves others as they are.
void unpack(std::string& bytes, std::string_view name);

/// Whether the file begins as gzip's do. A binary STL may begin in the same way, and counts as none.
bool is_gzip(std::string_view bytes);

/// The content of a gzip file, of all its members. Throws Error{unreadable_input} where it is cut off or damaged, or
/// goes beyond ExpansionLimit. Cost: O(bytes) of the content.
std::string unpack_gzip(std::string_view bytes, std::string_view name);

/// Whether a file is text in UTF-16, by its byte order mark. A binary STL may begin in the same way, and counts as
/// none.
bool is_utf16(std::string_view bytes);

/// Text in UTF-16 with a byte order mark as UTF-8 without; U+FFFD stands for what is no character. Cost: O(bytes).
std::string to_utf8(std::string_view utf16);

/// Names the content of a file that is no mesh, and says what to do about it: "an HTML page; ...". Empty where no mark
/// tells. Cost: O(1), of JSON O(bytes).
std::string describe_content(std::string_view bytes);

}  // namespace gvd
