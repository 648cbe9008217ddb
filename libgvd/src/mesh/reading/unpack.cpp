// Unpacks the wrapping of a file, and recognises contents that are no mesh by the marks in the specifications of their
// formats.
#include "mesh/reading/unpack.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "gvd/error.hpp"
#include "gvd/text.hpp"
#include "gvd/text_encoding.hpp"
#include "mesh/reading/readers.hpp"
#include "mesh/reading/stored_numbers.hpp"

namespace gvd {
namespace {

/// How many bytes are searched for a mark that need not be at the beginning.
constexpr std::size_t kSearchedBytes = 4096;

struct Mark {
  std::string_view bytes;  ///< at the beginning of the file
  std::string_view meaning;
};

constexpr std::array<Mark, 13> kMarks{{
    {"version https://git-lfs", "a Git LFS pointer; fetch the file that it stands for with 'git lfs pull'"},
    {"\x89PNG", "a PNG image; give the mesh"},
    {"\xff\xd8\xff", "a JPEG image; give the mesh"},
    {"GIF8", "a GIF image; give the mesh"},
    {"%PDF-", "a PDF document; give the mesh"},
    {"\x7f"
     "ELF",
     "a program; give the mesh"},
    {"Kaydara FBX", "an FBX scene; export the mesh as GLB, PLY or OBJ"},
    {"BLENDER", "a Blender file; export the mesh as GLB, PLY or OBJ"},
    {"ISO-10303-21", "a STEP file; export a triangle mesh from the CAD program"},
    {"\x89HDF", "an HDF5 file; export the mesh as VTP, PLY or OBJ"},
    {"#VRML", "a VRML scene; convert it to GLB, PLY or OBJ"},
    {"$MeshFormat", "a Gmsh mesh; convert it to VTK or OBJ"},
    {"MeshVersionFormatted", "a Medit mesh; convert it to VTK or OBJ"},
}};

/// Whether a zip archive holds a 3MF model, by the names of its files. The names are before each file and in the list
/// at the end of the archive.
bool is_3mf(std::string_view zip) {
  constexpr std::size_t kList = 1 << 16;
  const std::string_view end = zip.substr(zip.size() - std::min(zip.size(), kList));
  return to_lower(zip.substr(0, kSearchedBytes)).find("3d/3dmodel.model") != std::string::npos ||
         to_lower(end).find("3d/3dmodel.model") != std::string::npos;
}

/// Whether a file is an object of MNI in binary: `p`, five floats for the shading, and the number of points. A number
/// below 16 million has a zero among its bytes, and text has no zero.
bool is_binary_mni(std::string_view bytes) {
  constexpr std::size_t kHeader = 4 * (5 + 1);
  return bytes.starts_with('p') && bytes.size() > kHeader && bytes.substr(1, kHeader).find('\0') != bytes.npos;
}

/// How many ASCII characters distinguish UTF-16 from binary files, in which single zeros are common.
constexpr std::size_t kTellingCharacters = 4;

/// Appends a character of Unicode in UTF-8.
void append_utf8(std::string& text, std::uint32_t c) {
  if (c < 0x80) {
    text += static_cast<char>(c);
    return;
  }
  const int more = c < 0x800 ? 1 : c < 0x10000 ? 2 : 3;
  constexpr std::array<std::uint32_t, 4> kFirst{0, 0xC0, 0xE0, 0xF0};
  text += static_cast<char>(kFirst[std::size_t(more)] | c >> 6 * more);
  for (int i = more - 1; i >= 0; --i) text += static_cast<char>(0x80 | (c >> 6 * i & 0x3F));
}

/// The name of the first element of an XML document; empty if there is none.
std::string_view root_element(std::string_view xml) {
  for (std::size_t at = xml.find('<'); at < xml.size(); at = xml.find('<', at + 1)) {
    const std::string_view name = xml.substr(at + 1);
    if (!name.empty() && name[0] != '?' && name[0] != '!') return name.substr(0, name.find_first_of(" \t\r\n/>"));
  }
  return {};
}

}  // namespace

void ExpansionLimit::spend(std::uint64_t bytes) {
  if (bytes > left_) {
    throw Error(ErrorCode::unreadable_input,
                fmt::format("{}: the file expands to more than {} times its size; unpack it first, or convert it",
                            name_, kMostExpansion));
  }
  left_ -= bytes;
}

bool is_gzip(std::string_view bytes) { return find_compression(bytes) == "gzip" && !is_binary_stl(bytes); }

bool is_utf16(std::string_view bytes) { return has_utf16_mark(bytes) && !is_binary_stl(bytes); }

std::string to_utf8(std::string_view utf16) {
  constexpr std::uint32_t kUnknown = 0xFFFD, kHigh = 0xD800, kLow = 0xDC00, kAbove = 0xE000;
  const StoredNumber stored{StoredNumber::Kind::unsigned_integer, 2, utf16.starts_with("\xfe\xff")};
  const auto unit = [&](std::size_t at) {
    return at + 2 > utf16.size() ? 0 : static_cast<std::uint32_t>(stored.read_bits(utf16.data() + at));
  };
  std::string text;
  text.reserve(utf16.size() / 2);
  for (std::size_t at = 2; at < utf16.size(); at += 2) {
    const std::uint32_t first = unit(at), second = unit(at + 2);
    if (at + 2 > utf16.size()) {  // an odd byte at the end
      append_utf8(text, kUnknown);
    } else if (first < kHigh || first >= kAbove) {
      append_utf8(text, first);
    } else if (first < kLow && second >= kLow && second < kAbove) {
      append_utf8(text, 0x10000 + ((first - kHigh) << 10) + (second - kLow));
      at += 2;
    } else {
      append_utf8(text, kUnknown);
    }
  }
  return text;
}

void unpack(std::string& bytes, std::string_view name) {
  if (is_gzip(bytes)) bytes = unpack_gzip(bytes, name);
  if (is_utf16(bytes)) bytes = to_utf8(bytes);
}

std::string describe_content(std::string_view bytes) {
  if (is_binary_stl(bytes)) return "";  // a binary STL may begin with any bytes
  if (is_unmarked_utf16(bytes, kTellingCharacters)) return "text in UTF-16 without a byte order mark; save it as UTF-8";
  if (is_binary_mni(bytes)) return "a binary object of MNI; write it as text, or as PLY";
  if (bytes.starts_with(std::string_view("\xff\xfe\0\0", 4)) ||
      bytes.starts_with(std::string_view("\0\0\xfe\xff", 4))) {
    return "text in UTF-32; save it as UTF-8";
  }
  const std::string_view program = find_compression(bytes);
  if (program == "zip" && is_3mf(bytes)) return "a 3MF model; export the mesh as STL, PLY or OBJ";
  if (!program.empty()) return fmt::format("compressed by {}; unpack it first", program);
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  bytes.remove_prefix(std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size()));
  const auto* mark = std::ranges::find_if(kMarks, [&](const Mark& m) { return bytes.starts_with(m.bytes); });
  if (mark != kMarks.end()) return std::string(mark->meaning);
  if (is_json(bytes) && bytes.find("\"asset\"") == bytes.npos) {
    return "JSON but not glTF (no member 'asset'); give the mesh";
  }
  const std::string begin = to_lower(bytes.substr(0, kSearchedBytes));
  if (begin.starts_with("<!doctype html") || begin.starts_with("<html")) {
    return "an HTML page; download the file that it leads to";
  }
  if (!begin.starts_with("<")) return "";
  const std::string_view root = root_element(bytes.substr(0, kSearchedBytes));
  if (root == "VTKFile" || root == "GIFTI") return "";
  return fmt::format("XML of the kind {}; of XML, only VTK's (.vtp, .vtu) and GIFTI (.gii) are read", quoted(root));
}

}  // namespace gvd
