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

// The formats of files: a row of a table for each. Whatever chooses, lists or explains formats asks this table.
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

/// What a file can hold, or what a result consists of: a set of these, joined by |.
enum class Content : std::uint32_t {
  nothing = 0,
  surface = 1U << 0,        ///< vertices and triangles
  doubles = 1U << 1,        ///< numbers keep every bit; otherwise they are 32-bit floats
  place = 1U << 2,          ///< where a mesh is that lies far from the origin, without doubles
  face_labels = 1U << 3,    ///< as numbers or names
  vertex_labels = 1U << 4,  ///< as numbers or names
  colors = 1U << 5,         ///< of the labels
  face_numbers = 1U << 6,   ///< the parents of faces, their regions and levels
  distances = 1U << 7,      ///< one for each vertex
  curves = 1U << 8,         ///< bisectors, paths and isolines as lines beside the surface
  texture = 1U << 9,        ///< texture coordinates
  materials = 1U << 10,     ///< names of materials
  properties = 1U << 11,    ///< further properties of vertices and faces
  diagram = 1U << 12,       ///< generators, bisectors, branch points and cells as such
  rows = 1U << 13,          ///< several distances for each vertex, one from each source
  targets = 1U << 14,       ///< distances of listed points
  paths = 1U << 15,         ///< their points, without a surface
  isolines = 1U << 16,      ///< their points, without a surface
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

/// Whether a set has one of `any`.
constexpr bool has_any(Content set, Content any) {
  return (static_cast<std::uint32_t>(set) & static_cast<std::uint32_t>(any)) != 0;
}

/// A row of the table.
struct Format {
  /// The polygons of a whole file. `name` stands for it in messages; `folder` has the files that it may refer to.
  using Reader = PolygonSoup (*)(std::string_view bytes, std::string_view name,
                                 const std::optional<std::filesystem::path>& folder);
  using PropertyReader = std::optional<SoupProperty> (*)(std::string_view bytes, std::string_view property,
                                                         std::string_view name, SoupElement preferred);

  MeshFormat id;
  std::string_view name;        ///< of an input: "gii"
  std::string_view title = {};  ///< of formats that are read, in messages: "GIFTI"
  /// In small letters, without dots. The first one names the format of an output, the others stand for the same.
  std::vector<std::string> extensions;
  Content carries = Content::nothing;
  bool is_binary = false;
  /// How the names of inputs end, too, where programs call them by what they hold.
  std::vector<std::string> input_extensions = {};
  /// Whether a file's content is of this format, and of no other. Null: nothing tells.
  bool (*is_content)(std::string_view bytes) = nullptr;
  Reader read = nullptr;  ///< null: no mesh can be read from it
  /// A mesh with its labels and the like. Null: the format is not written or, where it is not read either, what it
  /// holds differs from command to command, which write it themselves.
  void (*write)(std::ostream& out, const io::ColoredMesh& mesh) = nullptr;
  PropertyReader read_property = nullptr;  ///< one property, by its name
  std::vector<MeshProperty> (*read_properties)(std::string_view bytes, std::string_view name) = nullptr;  ///< all

  bool is_output() const { return write != nullptr || read == nullptr; }
};

/// The table, in the order of MeshFormat.
const std::vector<Format>& formats();

const Format& format_row(MeshFormat format);

/// The names of the formats that meshes are read from.
Choices<MeshFormat> input_format_names();

/// The format of a written file's extension, with or without its dot, in upper or lower case. Null for any other text.
const Format* find_output(std::string_view extension);

/// The first extensions of the formats that are written and carry any of `any`, but nothing of `none`.
std::vector<std::string> output_extensions(Content any, Content none = Content::nothing);

/// ".ply, .obj and .glb"; `last` is "and" or "or".
std::string list_extensions(const std::vector<std::string>& extensions, std::string_view last);

/// "only .ply, .obj and .glb hold": the formats that are written and carry any of `any`, and `others`, such as options.
std::string only_formats(Content any, const std::vector<std::string>& others = {});

}  // namespace gvd
