#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace gvd::io {

/// The arrays of a page: little-endian, in Base64, equal ones stored once.
class ViewBlobs {
 public:
  /// Adds an array of 32-bit floats. Returns its reference for the manifest: {"blob", "type", "count"}.
  nlohmann::json add_floats(const std::vector<float>& values);

  /// Adds an array of unsigned integers in the narrowest of 8, 16 and 32 bits that holds the largest of them.
  nlohmann::json add_integers(const std::vector<std::uint32_t>& values);

  /// One element `<script type="application/octet-stream" id="blob-K">` for each array, in the order in which they were
  /// added.
  std::string html() const;

 private:
  nlohmann::json add(std::string bytes, const char* type, std::size_t count);

  std::map<std::string, std::size_t> index_of_;
  std::vector<const std::string*> blobs_;  ///< keys of index_of_, which do not move
};

}  // namespace gvd::io
