// Reads the container of glTF 2.0, binary (.glb) or as JSON (.gltf): its chunks, its description, and the numbers in
// its buffers.
//
// Accessors describe numbers in buffers, which are the binary chunk, data URIs, or files beside the mesh.
// Source: Khronos, glTF 2.0 (ISO/IEC 12113), sections 3.6 and 4.4.
#include "mesh/reading/gltf_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "gvd/error.hpp"
#include "gvd/text.hpp"
#include "mesh/reading/gltf_buffers.hpp"
#include "mesh/reading/readers.hpp"

namespace gvd {
namespace {

using Json = nlohmann::json;

constexpr std::string_view kMark = "glTF";
constexpr std::uint32_t kVersion = 2, kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;
constexpr std::size_t kHeaderBytes = 12, kChunkHeaderBytes = 8;

/// Converts a number to a size. A number that is too large becomes the largest size, because its remainder could pass
/// for a valid count.
std::size_t as_size(const Json& value) {
  return std::size_t(std::min<std::uint64_t>(value.get<std::uint64_t>(), std::numeric_limits<std::size_t>::max()));
}

/// Formats a count of bytes, which in a damaged file may exceed 63 bits.
std::string byte_count(std::size_t count) { return fmt::format("{} {}", count, count == 1 ? "byte" : "bytes"); }

/// The integer that stands for 1 in normalized integers.
double largest(const StoredNumber& stored) {
  return std::exp2(8.0 * double(stored.size) - (stored.kind == StoredNumber::Kind::signed_integer ? 1 : 0)) - 1;
}

}  // namespace

GltfFile::GltfFile(std::string_view bytes, std::string_view name, const std::optional<std::filesystem::path>& folder)
    : bytes_(bytes), name_(name), folder_(folder), limit_(bytes.size(), name) {
  is_binary_ = bytes.starts_with(kMark);
  if (!is_binary_ && !is_json(bytes)) refuse("the file begins neither with 'glTF' nor, as JSON, with '{'");
  gltf_ = Json::parse(is_binary_ ? read_chunks() : bytes);
  if (!gltf_.is_object()) refuse("the scene's description is not a JSON object");
  check_version();
}

const Json& GltfFile::array(const char* key) const {
  static const Json kNone = Json::array();
  const auto found = gltf_.find(key);
  return found == gltf_.end() ? kNone : *found;
}

const Json& GltfFile::item(const char* key, std::size_t i) const {
  const Json& items = array(key);
  if (i >= items.size()) refuse(fmt::format("there is no item {} of {}", i, key));
  return items.at(i);
}

std::size_t GltfFile::number(const Json& object, const char* key, std::optional<std::size_t> otherwise) const {
  const auto found = object.find(key);
  if (found == object.end() && otherwise) return *otherwise;
  if (found == object.end() || !found->is_number_unsigned()) refuse(fmt::format("'{}' is not an index or count", key));
  return as_size(*found);
}

std::size_t GltfFile::index(const Json& value, const char* what) const {
  if (!value.is_number_unsigned()) refuse(fmt::format("an index of {} is not a whole number", what));
  return as_size(value);
}

Accessor GltfFile::read_accessor(std::size_t a) {
  const Json& accessor = item("accessors", a);
  if (accessor.contains("sparse")) refuse(fmt::format("accessor {} is sparse, which is not read", a));
  if (!accessor.contains("bufferView")) refuse(fmt::format("accessor {} has no numbers", a));
  const StoredNumber stored = stored_number(number(accessor, "componentType"));
  const std::string type = accessor.at("type");
  Accessor read{{}, type == "SCALAR" ? 1U : type == "VEC2" ? 2U : type == "VEC3" ? 3U : 0U};
  if (read.size == 0) refuse(fmt::format("accessor {} has the type {}", a, gvd::quoted(type)));
  const std::size_t v = number(accessor, "bufferView");
  const std::string_view view = find_view(v);
  const std::size_t count = number(accessor, "count"), begin = number(accessor, "byteOffset", 0);
  const std::size_t element = read.size * stored.size;
  const std::size_t given = number(item("bufferViews", v), "byteStride", 0);
  const std::size_t stride = given == 0 ? element : given;
  if (count == 0) return read;
  if (stride < element) {
    refuse(fmt::format("accessor {} has elements of {}, and its view steps by {} ('byteStride'); {}", a,
                       byte_count(element), stride, kExportAgain));
  }
  const std::size_t first = number(item("bufferViews", v), "byteOffset", 0) + begin;
  if (first % stored.size != 0 || stride % stored.size != 0) {
    refuse(
        fmt::format("accessor {} has numbers of {} bytes at byte {} of its buffer and each {} bytes on, which are "
                    "no multiples of {}; {}",
                    a, stored.size, first, stride, stored.size, kExportAgain));
  }
  if (begin > view.size() || element > view.size() - begin || count - 1 > (view.size() - begin - element) / stride) {
    refuse(fmt::format("accessor {} has {}, and its view has {}", a, counted(count, "element", "elements"),
                       byte_count(view.size())));
  }
  limit_.spend(std::uint64_t(count) * read.size * sizeof(double));
  read.numbers.reserve(count * read.size);
  const bool is_fraction = accessor.value("normalized", false) && stored.kind != StoredNumber::Kind::real;
  const double scale = is_fraction ? largest(stored) : 1, least = is_fraction ? -scale : -kInfinity;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < read.size; ++k) {
      const double number = stored.read(view.data() + begin + i * stride + k * stored.size);
      read.numbers.push_back(std::max(number, least) / scale);
    }
  }
  return read;
}

std::vector<std::filesystem::path> GltfFile::other_files() const {
  std::vector<std::filesystem::path> files;
  for (const char* kind : {"buffers", "images"}) {
    for (const Json& described : array(kind)) {
      const auto address = described.find("uri");
      if (address == described.end() || !address->is_string()) continue;
      if (auto file = gltf_file(address->get_ref<const std::string&>())) files.push_back(*std::move(file));
    }
  }
  return files;
}

void GltfFile::refuse(const std::string& message) const {
  throw Error(ErrorCode::unreadable_input, fmt::format("{}: {}", name_, message));
}

std::uint32_t GltfFile::word(std::size_t at) const {
  if (at + 4 > bytes_.size()) refuse(fmt::format("the file ends at byte {}, inside a header", bytes_.size()));
  return static_cast<std::uint32_t>(StoredNumber{.size = 4}.read_bits(bytes_.data() + at));
}

/// Finds the binary chunk, and returns the description.
std::string_view GltfFile::read_chunks() {
  if (word(4) != kVersion) refuse(fmt::format("the file has version {} of glTF, and only 2 is read", word(4)));
  const std::size_t whole = word(8);
  if (whole <= kHeaderBytes) {
    refuse(fmt::format("the header says that the file has {}, which is no more than the header itself; {}",
                       byte_count(whole), kExportAgain));
  }
  bytes_ = bytes_.substr(0, whole);  // ignores bytes after the length that the file declares
  std::string_view json;
  for (std::size_t at = kHeaderBytes; at < bytes_.size();) {
    const std::size_t length = word(at), begin = at + kChunkHeaderBytes;
    const std::uint32_t kind = word(at + 4);
    if (length > bytes_.size() - begin) {
      refuse(fmt::format("byte {}: a chunk should have {}, and the file has {} more", at, byte_count(length),
                         bytes_.size() - begin));
    }
    if (kind == kJsonChunk && json.empty()) json = bytes_.substr(begin, length);
    if (kind == kBinaryChunk && binary_.empty()) binary_ = bytes_.substr(begin, length);
    at = begin + length;
  }
  if (whole > bytes_.size()) {
    refuse(
        fmt::format("the header says that the file has {} bytes, and it has {}; copy it again", whole, bytes_.size()));
  }
  return json;
}

void GltfFile::check_version() const {
  const auto asset = gltf_.find("asset");
  if (asset == gltf_.end()) return;  // a valid file has this member, but nothing depends on it
  const std::string version = asset->value("version", "2.0"), least = asset->value("minVersion", "2.0");
  if (!version.starts_with("2.") || least != "2.0") {
    refuse(fmt::format("the file has version {} of glTF, and only 2.0 is read",
                       gvd::quoted(least == "2.0" ? version : least)));
  }
}

/// The bytes of a buffer. Each buffer and each file is read only once. Addresses may be long, so they are compared once
/// for each buffer and not for each view.
std::string_view GltfFile::find_buffer(std::size_t b) {
  const auto known = buffers_.find(b);
  if (known != buffers_.end()) return known->second;
  const Json& buffer = item("buffers", b);
  const auto address = buffer.find("uri");
  std::string_view stored;
  if (address != buffer.end()) {
    const auto& uri = address->get_ref<const std::string&>();
    const auto [content, is_new] = contents_.try_emplace(uri);
    if (is_new) content->second = read_gltf_buffer(uri, b, folder_, limit_, name_);
    stored = content->second;
  } else if (is_binary_ && b == 0) {
    stored = binary_;
  } else {
    refuse(fmt::format("buffer {} has no address, and only the first one of a .glb may lack it", b));
  }
  const std::size_t length = number(buffer, "byteLength", stored.size());
  if (length > stored.size()) {
    refuse(fmt::format("buffer {} should have {}, and has {}; {}", b, byte_count(length), stored.size(), kExportAgain));
  }
  return buffers_[b] = stored.substr(0, length);  // removes the padding of a chunk
}

StoredNumber GltfFile::stored_number(std::size_t component_type) const {
  using Kind = StoredNumber::Kind;
  constexpr std::size_t kByte = 5120, kFloat = 5126;
  static constexpr std::array<StoredNumber, 7> kTypes{{{Kind::signed_integer, 1},
                                                       {Kind::unsigned_integer, 1},
                                                       {Kind::signed_integer, 2},
                                                       {Kind::unsigned_integer, 2},
                                                       {Kind::signed_integer, 4},
                                                       {Kind::unsigned_integer, 4},
                                                       {Kind::real, 4}}};
  if (component_type < kByte || component_type > kFloat) {
    refuse(fmt::format("an accessor has the component type {}", component_type));
  }
  return kTypes[component_type - kByte];
}

std::string_view GltfFile::find_view(std::size_t v) {
  const Json& view = item("bufferViews", v);
  const std::size_t b = number(view, "buffer");
  const std::string_view buffer = find_buffer(b);
  const std::size_t begin = number(view, "byteOffset", 0), length = number(view, "byteLength");
  if (begin > buffer.size() || length > buffer.size() - begin) {
    refuse(
        fmt::format("view {} has {} from {} on, and buffer {} has {}", v, byte_count(length), begin, b, buffer.size()));
  }
  return buffer.substr(begin, length);
}

}  // namespace gvd
