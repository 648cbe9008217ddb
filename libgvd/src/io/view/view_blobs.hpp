#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace gvd::io {

/// The arrays of a page: little-endian, deflated and in Base64. Equal arrays are stored once.
class ViewBlobs {
 public:
  /// Adds an array of 32-bit floats. Returns its reference for the manifest: {"blob", "type", "count"}.
  nlohmann::json add_floats(const std::vector<float>& values);

  /// Adds the coordinates of points in the page's frame, three for each point, as multiples of 2^-20: one pixel of a
  /// screen of 2,000 pixels, zoomed in a thousand times. Stores differences, because neighbours in the list are mostly
  /// near each other.
  /// Returns {"blob", "type", "count", "unit", "step": 3}.
  nlohmann::json add_coordinates(const std::vector<double>& values);

  /// Adds numbers from 0 to 1 as multiples of 1/65535, such that b and 1 - b stay complements. Returns {"blob", "type",
  /// "count", "unit"}.
  nlohmann::json add_shares(const std::vector<double>& values);

  /// Adds an array of unsigned integers in the narrowest of 8, 16 and 32 bits that holds the largest of them.
  nlohmann::json add_integers(const std::vector<std::uint32_t>& values);

  /// An element `<script type="application/octet-stream" id="blob-K">` for each array, in the order in which they were
  /// added.
  std::string html() const;

  /// The bytes of each array, by the number of its reference.
  const std::vector<const std::string*>& all() const { return blobs_; }

 private:
  nlohmann::json add(std::string bytes, const char* type, std::size_t count);

  std::map<std::string, std::size_t> index_of_;
  std::vector<const std::string*> blobs_;  ///< keys of index_of_, which do not move
};

}  // namespace gvd::io
