// Encodes the arrays of a page as bytes.
#include "io/view/view_blobs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "io/writers/byte_writer.hpp"

namespace gvd::io {
namespace {

using nlohmann::json;

/// The page's coordinates are multiples of 1 / kCoordinateParts, and the barycentric coordinates of a piece's corners
/// are multiples of 1 / kShareParts.
constexpr double kCoordinateParts = 1 << 20, kShareParts = 65535;

/// Coordinates are clamped to this. The frame has a radius of 1 unless the mesh is too large for a frame; differences
/// of twice this bound fit into 31 bits.
constexpr double kFarthest = 500;

/// The smallest width of 1, 2 or 4 bytes that holds each of the values.
int width_of(const std::vector<std::uint32_t>& values) {
  const std::uint32_t largest = values.empty() ? 0 : *std::max_element(values.begin(), values.end());
  return largest < 0x100 ? 1 : largest < 0x10000 ? 2 : 4;
}

}  // namespace

nlohmann::json ViewBlobs::add_floats(const std::vector<float>& values) {
  std::string bytes;
  bytes.reserve(4 * values.size());
  for (const float value : values) bytes.append(little_endian(value).data(), 4);
  return add(std::move(bytes), "f32", values.size());
}

nlohmann::json ViewBlobs::add_coordinates(const std::vector<double>& values) {
  std::vector<std::uint32_t> steps;
  steps.reserve(values.size());
  std::array<std::int64_t, 3> before{};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::int64_t value = std::llround(std::clamp(values[i], -kFarthest, kFarthest) * kCoordinateParts),
                       step = value - before[i % 3];
    before[i % 3] = value;
    steps.push_back(std::uint32_t(step < 0 ? -2 * step - 1 : 2 * step));  // the lowest bit is the sign
  }
  const int width = width_of(steps);
  std::string bytes;  // the lowest bytes of all numbers, then the next ones: the higher bytes are mostly 0
  bytes.reserve(width * steps.size());
  for (int k = 0; k < width; ++k) {
    for (const std::uint32_t step : steps) bytes.push_back(char(step >> (8 * k) & 0xFF));
  }
  json reference = add(std::move(bytes), width == 1 ? "u8" : width == 2 ? "u16" : "u32", values.size());
  reference["unit"] = 1 / kCoordinateParts;
  reference["step"] = 3;
  return reference;
}

nlohmann::json ViewBlobs::add_shares(const std::vector<double>& values) {
  std::vector<std::uint32_t> parts;
  parts.reserve(values.size());
  for (const double value : values) {
    parts.push_back(std::uint32_t(std::lround(kShareParts * std::clamp(value, 0.0, 1.0))));
  }
  json reference = add_integers(parts);
  reference["unit"] = 1 / kShareParts;
  return reference;
}

nlohmann::json ViewBlobs::add_integers(const std::vector<std::uint32_t>& values) {
  const int width = width_of(values);
  std::string bytes;
  bytes.reserve(width * values.size());
  for (const std::uint32_t value : values) bytes.append(little_endian(value).data(), width);
  return add(std::move(bytes), width == 1 ? "u8" : width == 2 ? "u16" : "u32", values.size());
}

nlohmann::json ViewBlobs::add(std::string bytes, const char* type, std::size_t count) {
  const auto [it, fresh] = index_of_.try_emplace(std::move(bytes), blobs_.size());
  if (fresh) blobs_.push_back(&it->first);
  return {{"blob", it->second}, {"type", type}, {"count", count}};
}

}  // namespace gvd::io
