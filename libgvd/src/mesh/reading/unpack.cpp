// What a file is wrapped in: contents are named, by the marks of the formats' specifications.
#include "mesh/reading/unpack.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "gvd/error.hpp"
#include "gvd/text.hpp"
#include "mesh/reading/readers.hpp"

namespace gvd {
namespace {

/// Bytes that content is searched for a mark that need not come first.
constexpr std::size_t kSearchedBytes = 4096;

struct Mark {
  std::string_view bytes;  ///< at the beginning of the file
  std::string_view meaning;
};

constexpr std::array<Mark, 14> kMarks{{
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
    {"{", "JSON; of glTF, only binary files (.glb) are read"},
}};

/// The name of an XML document's first element that is no declaration; empty where there is none.
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
                fmt::format("{}: the file unfolds to more than {} times its size; unpack it first, or convert it",
                            name_, kMostExpansion));
  }
  left_ -= bytes;
}

bool is_gzip(std::string_view bytes) { return find_compression(bytes) == "gzip" && !is_binary_stl(bytes); }

std::string describe_content(std::string_view bytes) {
  if (is_binary_stl(bytes)) return "";  // it begins with anything
  const std::string_view program = find_compression(bytes);
  if (!program.empty()) return fmt::format("compressed by {}; unpack it first", program);
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  bytes.remove_prefix(std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size()));
  const auto* mark = std::ranges::find_if(kMarks, [&](const Mark& m) { return bytes.starts_with(m.bytes); });
  if (mark != kMarks.end()) return std::string(mark->meaning);
  const std::string begin = to_lower(bytes.substr(0, kSearchedBytes));
  if (begin.starts_with("<!doctype html") || begin.starts_with("<html")) {
    return "an HTML page; download the file that it leads to";
  }
  if (!begin.starts_with("<")) return "";
  const std::string_view root = root_element(bytes.substr(0, kSearchedBytes));
  if (root == "VTKFile" || root == "GIFTI") return "";
  return fmt::format("XML of the kind {}; of XML, only VTK's PolyData (.vtp) and GIFTI (.gii) are read", quoted(root));
}

}  // namespace gvd
