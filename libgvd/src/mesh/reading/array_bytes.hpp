#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/reading/unpack.hpp"

namespace gvd {

/// The bytes of an array in XML, as they are or in Base64.
///
/// Base64 comes in runs that end in padding: a compressed array of VTK has one for its header and one for its blocks,
/// so the decoder goes on behind a padding.
class ArrayBytes {
 public:
  ArrayBytes(std::string_view data, bool is_base64) : data_(data), is_base64_(is_base64) {}

  /// Upper bound on the bytes that are left.
  std::uint64_t most() const { return pending_.size() + data_.size(); }
  /// The next bytes; fewer where the data end or hold anything but Base64.
  std::string take(std::uint64_t count);

 private:
  bool decode_four(std::string& bytes);

  std::string_view data_;  // what is left
  bool is_base64_;
  std::string pending_;  // decoded and not taken
};

/// Appends what zlib makes of `packed`. False where that is not `size` bytes, or the data are damaged. Throws what
/// `limit` throws, before it takes memory. `unused`, if not null, gets the number of bytes behind the end of the data.
bool append_inflated(std::string& content, std::string_view packed, std::uint64_t size, ExpansionLimit& limit,
                     std::uint64_t* unused = nullptr);

/// The number of bytes that zlib makes of `packed`, or `most` where there are more; nothing where the data are damaged.
std::optional<std::uint64_t> inflated_size(std::string_view packed, std::uint64_t most);

/// The whole number from 0 that an attribute of XML spells, which may have blanks round it; nothing for any other text.
std::optional<std::uint64_t> parse_count(std::string_view text);

/// The numbers of a text, with blanks between them. Throws Error{unreadable_input} for anything else; `what` is the
/// array in the message, `name` the file. Cost: O(length).
std::vector<double> parse_array_text(std::string_view text, std::string_view what, std::string_view name);

}  // namespace gvd
