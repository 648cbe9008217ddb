// Reads the buffers of glTF that are not in its binary chunk: data URIs, and files beside the mesh.
//
// A mesh from the Internet must not make a program read other files, whose bytes would end up as coordinates. So each
// part of the decoded name is checked, and after following links it must lead to a regular file below the folder of the
// mesh. A name is decoded once, before it is checked: "%2e%2e" is "..", and "%252e" is the name "%2e".
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

constexpr std::string_view kData = "data:";

bool is_data_uri(std::string_view uri) { return to_lower(uri.substr(0, kData.size())) == kData; }

/// Decodes the percent-encoded bytes of an address; returns nothing if a '%' lacks its two digits.
std::optional<std::string> decode_percents(std::string_view uri) {
  std::string path;
  for (std::size_t at = 0; at < uri.size(); ++at) {
    if (uri[at] != '%') {
      path += uri[at];
      continue;
    }
    const std::string_view digits = uri.substr(at + 1, 2);
    std::uint8_t byte = 0;
    const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), byte, 16);
    if (digits.size() != 2 || result.ec != std::errc() || result.ptr != digits.data() + 2) return std::nullopt;
    path += static_cast<char>(byte);
    at += 2;
  }
  return path;
}

/// Sets `relative` to the path of an address, relative to the folder of the mesh. If the address has no such path,
/// returns the reason.
std::string_view find_relative_path(std::string_view uri, std::filesystem::path& relative) {
  const std::optional<std::string> path = decode_percents(uri);
  if (!path) return "has a '%' without two digits after it";
  if (path->find(':') != path->npos) {
    return "is an address, and only files in the folder of the mesh are read; put it there, or export one .glb";
  }
  const bool is_plain = std::ranges::none_of(*path, [](char c) { return std::uint8_t(c) < ' ' || c == '\\'; });
  if (path->empty() || !is_plain) return "is not the name of a file";
  relative = *path;
  if (path->front() == '/' || std::find(relative.begin(), relative.end(), "..") != relative.end()) {
    return "is not in the folder of the mesh; put it there, or export one .glb";
  }
  return {};
}

}  // namespace

std::optional<std::filesystem::path> gltf_file(std::string_view uri) {
  std::filesystem::path relative;
  if (is_data_uri(uri) || !find_relative_path(uri, relative).empty()) return std::nullopt;
  return relative;
}

std::string read_gltf_buffer(std::string_view uri, std::size_t b, const std::optional<std::filesystem::path>& folder,
                             ExpansionLimit& limit, std::string_view name) {
  namespace fs = std::filesystem;
  const auto refuse = [&](std::string_view what) {
    throw Error(ErrorCode::unreadable_input, fmt::format("{}: buffer {}, {}, {}", name, b, quoted(uri), what));
  };
  if (is_data_uri(uri)) {
    const std::size_t comma = std::min(uri.find(','), uri.size());
    if (!to_lower(uri.substr(0, comma)).ends_with(";base64")) refuse("is a data URI without Base64");
    ArrayBytes data(uri.substr(std::min(comma + 1, uri.size())), true);
    std::string bytes = data.take(data.most());
    if (data.most() > 0) refuse("is a data URI whose Base64 is damaged");
    return bytes;
  }
  if (!folder) refuse("is not in the file; name the mesh by its path, with the buffer beside it, or export one .glb");
  fs::path relative;
  if (const std::string_view why = find_relative_path(uri, relative); !why.empty()) refuse(why);
  std::error_code error;
  const fs::path root = fs::canonical(folder->empty() ? fs::path(".") : *folder, error);
  const fs::path file = error ? fs::path() : fs::canonical(root / relative, error);
  if (error) refuse("is not there; put it beside the mesh, or export one .glb");
  const auto [end, below] = std::mismatch(root.begin(), root.end(), file.begin(), file.end());
  if (end != root.end()) refuse("leads out of the folder of the mesh by a symbolic link; put the file itself there");
  if (!fs::is_regular_file(file, error)) refuse("is not a file");
  std::ifstream in(file, std::ios::binary);
  if (!in) refuse("can't be opened; check its permissions");
  const std::uintmax_t size = fs::file_size(file, error);
  std::string bytes = read_to_end(in, error ? 0 : size);
  if (in.bad()) refuse("can't be read to its end");
  limit.add_file(bytes.size());
  return bytes;
}

}  // namespace gvd
