// The buffers of glTF that are not in its binary chunk: data URIs, and files beside the mesh.
//
// A mesh from the Internet must not lead a program to other files, whose bytes would come out as coordinates. So the
// decoded name is checked part by part, and what it leads to through links must be a regular file below the folder of
// the mesh. A name is decoded once, before it is checked: "%2e%2e" is "..", and "%252e" is the name "%2e".
// Source: RFC 3986 for addresses, RFC 2397 for data URIs; Khronos, glTF 2.0, sections 2.8 and 3.6.1.1.
#include "mesh/reading/gltf_buffers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <system_error>

#include "gvd/error.hpp"
#include "gvd/text.hpp"
#include "mesh/reading/array_bytes.hpp"

namespace gvd {
namespace {

class BufferReader {
 public:
  BufferReader(std::string_view uri, std::size_t b, std::string_view name) : uri_(uri), number_(b), name_(name) {}

  bool is_data() const { return to_lower(uri_.substr(0, kData.size())) == kData; }

  std::string read_data() const {
    const std::size_t comma = std::min(uri_.find(','), uri_.size());
    if (!to_lower(uri_.substr(0, comma)).ends_with(";base64")) refuse("is a data URI without Base64");
    ArrayBytes data(uri_.substr(std::min(comma + 1, uri_.size())), true);
    std::string bytes = data.take(data.most());
    if (data.most() > 0) refuse("is a data URI whose Base64 is damaged");
    return bytes;
  }

  std::string read_file(const std::filesystem::path& folder) const {
    namespace fs = std::filesystem;
    const fs::path relative = relative_path();
    std::error_code error;
    const fs::path root = fs::canonical(folder.empty() ? fs::path(".") : folder, error);
    const fs::path file = error ? fs::path() : fs::canonical(root / relative, error);
    if (error) refuse("is not there; put it beside the mesh, or export one .glb");
    const auto [end, below] = std::mismatch(root.begin(), root.end(), file.begin(), file.end());
    if (end != root.end()) {
      refuse("leads out of the folder of the mesh by a symbolic link; put the file itself there");
    }
    if (!fs::is_regular_file(file, error)) refuse("is no file");
    std::ifstream in(file, std::ios::binary);
    if (!in) refuse("can't be opened; check its permissions");
    const std::uintmax_t size = fs::file_size(file, error);
    std::string bytes = read_to_end(in, error ? 0 : size);
    if (in.bad()) refuse("can't be read to its end");
    return bytes;
  }

  [[noreturn]] void refuse(std::string_view what) const {
    throw Error(ErrorCode::unreadable_input, fmt::format("{}: buffer {}, {}, {}", name_, number_, quoted(uri_), what));
  }

  /// The address as a path that leads down from the folder of the mesh.
  std::filesystem::path relative_path() const {
    const std::string path = decode();
    if (path.find(':') != path.npos) {
      refuse("is an address, and only files in the folder of the mesh are read; put it there, or export one .glb");
    }
    const bool is_plain = std::ranges::none_of(path, [](char c) { return std::uint8_t(c) < ' ' || c == '\\'; });
    if (path.empty() || !is_plain) refuse("is no name of a file");
    bool leads_up = path.front() == '/';
    for (const std::filesystem::path& part : std::filesystem::path(path)) leads_up |= part == "..";
    if (leads_up) refuse("is not in the folder of the mesh; put it there, or export one .glb");
    return path;
  }

 private:
  static constexpr std::string_view kData = "data:";

  /// The address with its percent-encoded bytes decoded.
  std::string decode() const {
    std::string path;
    for (std::size_t at = 0; at < uri_.size(); ++at) {
      if (uri_[at] != '%') {
        path += uri_[at];
        continue;
      }
      const std::string_view digits = uri_.substr(at + 1, 2);
      std::uint8_t byte = 0;
      const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), byte, 16);
      if (digits.size() != 2 || result.ec != std::errc() || result.ptr != digits.data() + 2) {
        refuse("has a '%' without two digits behind it");
      }
      path += static_cast<char>(byte);
      at += 2;
    }
    return path;
  }

  std::string_view uri_;
  std::size_t number_;
  std::string_view name_;
};

}  // namespace

std::optional<std::filesystem::path> gltf_file(std::string_view uri) {
  const BufferReader reader(uri, 0, "");
  if (reader.is_data()) return std::nullopt;
  try {
    return reader.relative_path();
  } catch (const Error&) {
    return std::nullopt;
  }
}

std::string read_gltf_buffer(std::string_view uri, std::size_t b, const std::optional<std::filesystem::path>& folder,
                             ExpansionLimit& limit, std::string_view name) {
  const BufferReader reader(uri, b, name);
  if (reader.is_data()) return reader.read_data();
  if (!folder)
    reader.refuse("is not in the file; name the mesh by its path, with the buffer beside it, or export one .glb");
  std::string bytes = reader.read_file(*folder);
  limit.add_file(bytes.size());
  return bytes;
}

}  // namespace gvd
