#include "io/view/view_blobs.hpp"

#include <algorithm>
#include <bit>

namespace gvd::io {
namespace {

void append_little_endian(std::string& bytes, std::uint32_t value, int width) {
  for (int i = 0; i < width; ++i) bytes.push_back(static_cast<char>((value >> (8 * i)) & 0xFF));
}

}  // namespace

std::string encode_base64(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t taken = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8 | (k < taken ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text.push_back(k <= taken ? kDigits[(group >> (18 - 6 * k)) & 63] : '=');
    }
  }
  return text;
}

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
    html += "<script type=\"application/octet-stream\" id=\"blob-" + std::to_string(i) + "\">";
    html += encode_base64(*blobs_[i]);
    html += "</script>\n";
  }
  return html;
}

}  // namespace gvd::io
