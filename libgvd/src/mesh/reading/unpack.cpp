// What a file is wrapped in: gzip is unpacked, and other contents are named.
//
// A gzip file is a row of members; their contents follow each other. Zeros may fill it up to the block of a tape.
// Source: RFC 1952, by zlib. Marks are those of the formats' specifications.
// Invariant: unpacked bytes are counted while they come, so that a small file can't take all memory.
#include "mesh/reading/unpack.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "gvd/error.hpp"
#include "gvd/text.hpp"
#include "mesh/reading/readers.hpp"

namespace gvd {
namespace {

/// For inflateInit2: the largest window, and gzip's header.
constexpr int kGzipWindow = 15 + 16;

/// The first bytes of a member.
constexpr std::string_view kGzipMark = "\x1f\x8b";

/// zlib counts the input in 32 bits.
constexpr std::size_t kMostInput = std::numeric_limits<uInt>::max();

/// Bytes that content is searched for a mark that need not come first.
constexpr std::size_t kSearchedBytes = 4096;

class GzipReader {
 public:
  GzipReader(std::string_view bytes, std::string_view name) : bytes_(bytes), name_(name), limit_(bytes.size(), name) {
    if (inflateInit2(&stream_, kGzipWindow) != Z_OK) throw std::bad_alloc();
  }
  ~GzipReader() { inflateEnd(&stream_); }
  GzipReader(const GzipReader&) = delete;
  GzipReader& operator=(const GzipReader&) = delete;

  std::string unpack() {
    do {
      unpack_member();
      inflateReset(&stream_);
    } while (bytes_.starts_with(kGzipMark));
    if (bytes_.find_first_not_of('\0') != bytes_.npos) refuse_rest();
    return std::move(content_);
  }

 private:
  void unpack_member() {
    for (int status = Z_OK; status != Z_STREAM_END;) {
      std::array<Bytef, 1 << 14> block{};
      stream_.next_in = reinterpret_cast<const Bytef*>(bytes_.data());
      stream_.avail_in = static_cast<uInt>(std::min(bytes_.size(), kMostInput));
      stream_.next_out = block.data();
      stream_.avail_out = block.size();
      const uInt given = stream_.avail_in;
      status = inflate(&stream_, Z_NO_FLUSH);
      if (status != Z_OK && status != Z_STREAM_END) refuse(status);
      bytes_.remove_prefix(given - stream_.avail_in);
      const std::size_t made = block.size() - stream_.avail_out;
      limit_.spend(made);
      content_.append(reinterpret_cast<const char*>(block.data()), made);
    }
  }

  [[noreturn]] void refuse(int status) const {
    if (status == Z_MEM_ERROR) throw std::bad_alloc();
    throw Error(ErrorCode::unreadable_input,
                fmt::format("{}: gzip's data {} after {} unpacked bytes; get the file again", name_,
                            status == Z_BUF_ERROR ? "end" : "are damaged", content_.size()));
  }

  [[noreturn]] void refuse_rest() const {
    throw Error(ErrorCode::unreadable_input,
                fmt::format("{}: {} no gzip; remove them, or get the file again", name_,
                            counted(std::ssize(bytes_), "byte behind gzip's data is", "bytes behind gzip's data are")));
  }

  std::string_view bytes_;  // what is left
  std::string name_, content_;
  ExpansionLimit limit_;
  z_stream stream_{};
};

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

std::string unpack_gzip(std::string_view bytes, std::string_view name) { return GzipReader(bytes, name).unpack(); }

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
