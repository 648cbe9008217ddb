#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "gvd/mesh_property.hpp"
#include "gvd/names.hpp"
#include "gvd/polygon_soup.hpp"

// The table of file formats, with one row per format. All code that chooses, lists or explains formats uses this table.
namespace gvd {

namespace io {
struct ColoredMesh;
}

/// The formats of files that hold a mesh, numbers of its elements, or what was computed on it.
enum class MeshFormat {
  ply,
  obj,
  off,
  coff,
  stl,
  vtp,
  vtu,
  vtk,
  glb,
  gltf,
  gii,        ///< GIFTI with a surface
  label_gii,  ///< GIFTI with labels of vertices
  shape_gii,  ///< GIFTI with distances of vertices
  mni,
  fs,     ///< FreeSurfer's surface
  annot,  ///< FreeSurfer's labels of vertices, an annotation
  curv,   ///< FreeSurfer's distances of vertices
  json,
  npy,
  csv,
  txt,
};

/// The kinds of data that a file can hold, or that a result consists of. Sets of them are formed with |.
enum class Content : std::uint32_t {
  nothing = 0,
  surface = 1U << 0,      ///< vertices and triangles
  doubles = 1U << 1,      ///< numbers keep every bit; otherwise they are 32-bit floats
  place = 1U << 2,        ///< the position of a mesh that lies far from the origin, although numbers are 32-bit floats
  face_labels = 1U << 3,  ///< as numbers or names
  vertex_labels = 1U << 4,  ///< as numbers or names
  colors = 1U << 5,         ///< colours of the labels
  face_numbers = 1U << 6,   ///< further numbers of faces: their parents, regions and levels
  distances = 1U << 7,      ///< one for each vertex
  curves = 1U << 8,         ///< bisectors, paths and isolines as lines beside the surface
  texture = 1U << 9,        ///< texture coordinates
  materials = 1U << 10,     ///< names of materials
  properties = 1U << 11,    ///< further properties of vertices and faces
  diagram = 1U << 12,       ///< generators, bisectors, branch points and cells as such
  rows = 1U << 13,          ///< several distances for each vertex, one from each source
  targets = 1U << 14,       ///< distances of listed points
  paths = 1U << 15,         ///< points of shortest paths, without a surface
  isolines = 1U << 16,      ///< points of isolines, without a surface
  generators = 1U << 17,    ///< a list of them
};
inline const Choices<Content> kContentNames{
    {"surface", Content::surface},
    {"doubles", Content::doubles},
    {"place", Content::place},
    {"face labels", Content::face_labels},
    {"vertex labels", Content::vertex_labels},
    {"colours", Content::colors},
    {"face numbers", Content::face_numbers},
    {"distances", Content::distances},
    {"curves", Content::curves},
    {"texture coordinates", Content::texture},
    {"materials", Content::materials},
    {"properties", Content::properties},
    {"diagram", Content::diagram},
    {"rows of distances", Content::rows},
    {"distances of targets", Content::targets},
    {"paths", Content::paths},
    {"isolines", Content::isolines},
    {"generators", Content::generators},
};

constexpr Content operator|(Content a, Content b) {
  return static_cast<Content>(static_cast<std::uint32_t>(a) | static_cast<std::uint32_t>(b));
}

/// Whether `set` contains at least one element of `any`.
constexpr bool has_any(Content set, Content any) {
  return (static_cast<std::uint32_t>(set) & static_cast<std::uint32_t>(any)) != 0;
}

/// A row of the table: one file format.
struct Format {
  /// Reads the polygons of a whole file. `name` stands for the file in messages; `folder` has the files that it may
  /// refer to.
  using Reader = PolygonSoup (*)(std::string_view bytes, std::string_view name,
                                 const std::optional<std::filesystem::path>& folder);
  using PropertyReader = std::optional<SoupProperty> (*)(std::string_view bytes, std::string_view property,
                                                         std::string_view name, SoupElement preferred);

  MeshFormat id;
  std::string_view name;        ///< name of the input format, such as "gii"
  std::string_view title = {};  ///< name in messages, for formats that are read: "GIFTI"
  /// In lower case, without dots. The first one names the format of an output; the others are synonyms.
  std::vector<std::string> extensions;
  Content carries = Content::nothing;
  bool is_binary = false;
  /// Further endings of input names, for formats whose files are named after their content by other programs.
  std::vector<std::string> input_extensions = {};
  /// Tells whether a file's content has this format and no other. Null if the content can't tell.
  bool (*is_content)(std::string_view bytes) = nullptr;
  Reader read = nullptr;  ///< null if no mesh can be read from it
  /// Writes a mesh with its labels and other data. Null if the format is not written. Null, too, for formats that are
  /// not read either: they hold something different for each command, which writes them itself.
  void (*write)(std::ostream& out, const io::ColoredMesh& mesh) = nullptr;
  PropertyReader read_property = nullptr;  ///< reads one property by its name
  std::vector<MeshProperty> (*read_properties)(std::string_view bytes, std::string_view name) = nullptr;  ///< all

  bool is_output() const { return write != nullptr || read == nullptr; }
};

/// The table, in the order of MeshFormat.
const std::vector<Format>& formats();

/// The row of a format.
const Format& format_row(MeshFormat format);

/// The names of the formats from which meshes can be read.
Choices<MeshFormat> input_format_names();

/// The format of an output file with this extension, which may be in upper or lower case, with or without its dot. Null
/// for any other text.
const Format* find_output(std::string_view extension);

/// The first extension of each format that is written and carries something of `any` but nothing of `none`.
std::vector<std::string> output_extensions(Content any, Content none = Content::nothing);

/// ".ply, .obj and .glb"; `last` is "and" or "or".
std::string list_extensions(const std::vector<std::string>& extensions, std::string_view last);

/// "only .ply, .obj and .glb hold": lists the formats that are written and carry something of `any`, followed by
/// `others`, such as options.
std::string only_formats(Content any, const std::vector<std::string>& others = {});

}  // namespace gvd
