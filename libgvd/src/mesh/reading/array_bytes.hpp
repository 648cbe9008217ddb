#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/reading/unpack.hpp"

namespace gvd {

/// The bytes of an array in XML, raw or in Base64.
///
/// Base64 can consist of several runs that end in padding: a compressed array of VTK has one for its header and one for
/// its blocks. So the decoder continues after padding.
class ArrayBytes {
 public:
  ArrayBytes(std::string_view data, bool is_base64) : data_(data), is_base64_(is_base64) {}

  /// Upper bound on the remaining bytes.
  std::uint64_t most() const { return pending_.size() + data_.size(); }
  /// The next `count` bytes; fewer if the data end or contain anything but Base64.
  std::string take(std::uint64_t count);

 private:
  bool decode_four(std::string& bytes);

  std::string_view data_;  // not decoded yet
  bool is_base64_;
  std::string pending_;  // decoded, but not taken yet
};

/// Unpacks zlib's data `packed` and appends the result. Returns false if the result is not `size` bytes long or the
/// data are damaged. Throws what `limit` throws, before it allocates memory. `unused`, if not null, gets the number of
/// bytes after the end of the data.
bool append_inflated(std::string& content, std::string_view packed, std::uint64_t size, ExpansionLimit& limit,
                     std::uint64_t* unused = nullptr);

/// The number of bytes that zlib's data `packed` unpack to, but at most `most`; nothing if the data are damaged.
std::optional<std::uint64_t> inflated_size(std::string_view packed, std::uint64_t most);

/// Parses an attribute of XML as a whole number from 0, which may have blanks around it; returns nothing for any other
/// text.
std::optional<std::uint64_t> parse_count(std::string_view text);

/// Parses numbers separated by blanks. Throws Error{unreadable_input} for anything else; in the message `what` stands
/// for the array and `name` for the file. Cost: O(length).
std::vector<double> parse_array_text(std::string_view text, std::string_view what, std::string_view name);

}  // namespace gvd
