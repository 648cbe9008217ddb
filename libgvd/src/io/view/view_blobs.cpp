#include "io/view/view_blobs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <nlohmann/json.hpp>

#include "io/writers/base64.hpp"

namespace gvd::io {
namespace {

void append_little_endian(std::string& bytes, std::uint32_t value, int width) {
  for (int i = 0; i < width; ++i) bytes.push_back(static_cast<char>((value >> (8 * i)) & 0xFF));
}

}  // namespace

nlohmann::json ViewBlobs::add_floats(const std::vector<float>& values) {
  std::string bytes;
  bytes.reserve(4 * values.size());
  for (const float value : values) append_little_endian(bytes, std::bit_cast<std::uint32_t>(value), 4);
  return add(std::move(bytes), "f32", values.size());
}

nlohmann::json ViewBlobs::add_integers(const std::vector<std::uint32_t>& values) {
  const std::uint32_t largest = values.empty() ? 0 : *std::max_element(values.begin(), values.end());
  const int width = largest < 0x100 ? 1 : largest < 0x10000 ? 2 : 4;
  std::string bytes;
  bytes.reserve(static_cast<std::size_t>(width) * values.size());
  for (const std::uint32_t value : values) append_little_endian(bytes, value, width);
  return add(std::move(bytes), width == 1 ? "u8" : width == 2 ? "u16" : "u32", values.size());
}

nlohmann::json ViewBlobs::add(std::string bytes, const char* type, std::size_t count) {
  const auto [it, fresh] = index_of_.try_emplace(std::move(bytes), blobs_.size());
  if (fresh) blobs_.push_back(&it->first);
  return {{"blob", it->second}, {"type", type}, {"count", count}};
}

std::string ViewBlobs::html() const {
  std::string html;
  for (std::size_t i = 0; i < blobs_.size(); ++i) {
    html += fmt::format("<script type=\"application/octet-stream\" id=\"blob-{}\">", i);
    html += encode_base64(*blobs_[i]);
    html += "</script>\n";
  }
  return html;
}

}  // namespace gvd::io
