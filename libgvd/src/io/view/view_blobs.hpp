#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace gvd::io {

/// Base64 of RFC 4648, with padding. Cost: O(n).
std::string encode_base64(std::string_view bytes);

/// The arrays of a page: little-endian, each different one once.
class ViewBlobs {
 public:
  /// Adds an array of 32-bit floats. Returns its reference for the manifest: {"blob", "type", "count"}.
  nlohmann::json add_floats(const std::vector<float>& values);

  /// Adds an array of unsigned integers in the narrowest of 8, 16 and 32 bits that holds the largest of them.
  nlohmann::json add_integers(const std::vector<std::uint32_t>& values);

  /// One element `<script type="application/octet-stream" id="blob-K">` for each array, in the order of their adding.
  std::string html() const;

 private:
  nlohmann::json add(std::string bytes, const char* type, std::size_t count);

  std::map<std::string, std::size_t> index_of_;
  std::vector<const std::string*> blobs_;  ///< keys of index_of_, which do not move
};

}  // namespace gvd::io
