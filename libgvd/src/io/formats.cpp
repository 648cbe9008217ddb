// The table of formats: the names of each, how its content is recognised, what it holds, its reader and its writer.
//
// A mark at the beginning decides first. A binary STL has no mark, but its length must follow from its number of
// triangles. The other texts are told apart by their words: OFF and solid are keywords, MNI's surfaces begin with a P
// and numbers, and an OBJ begins with one of eleven statements. So MNI's files, which are also called .obj, are not
// mistaken for Wavefront's.
// Invariant: no content matches two rows, so the order of the rows only decides the order of lists in messages.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "gvd/io/format.hpp"
#include "gvd/text.hpp"
#include "io/writers/format_writers.hpp"
#include "mesh/reading/readers.hpp"

namespace gvd {
namespace {

/// Whether the first word of the first line is ply, as the reader demands. A byte order mark and blanks may precede it.
bool is_ply(std::string_view bytes) {
  constexpr std::string_view kBlanks = " \t\v\f";
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  bytes.remove_prefix(std::min(bytes.find_first_not_of(kBlanks), bytes.size()));
  return bytes.size() > 3 && bytes.starts_with("ply") && std::string_view(" \t\v\f\r\n").find(bytes[3]) != bytes.npos;
}

bool is_glb(std::string_view bytes) { return bytes.starts_with("glTF"); }
bool is_vtk(std::string_view bytes) { return bytes.starts_with("# vtk DataFile"); }
bool is_freesurfer(std::string_view bytes) { return bytes.starts_with(kFreeSurferSurface); }
bool is_vtk_xml(std::string_view bytes) { return is_xml_of(bytes, "<VTKFile"); }
bool is_vtu(std::string_view bytes) { return is_vtk_xml(bytes) && is_xml_of(bytes, "UnstructuredGrid"); }
bool is_vtp(std::string_view bytes) { return is_vtk_xml(bytes) && !is_xml_of(bytes, "UnstructuredGrid"); }
bool is_gifti(std::string_view bytes) { return is_xml_of(bytes, "<GIFTI") && !is_vtk_xml(bytes); }

/// Whether the content begins with the mark of a format.
bool has_mark(std::string_view bytes) {
  return is_ply(bytes) || is_glb(bytes) || is_vtk(bytes) || is_freesurfer(bytes) || is_vtk_xml(bytes) ||
         is_gifti(bytes);
}

/// Whether the content is as long as a binary STL, whose header may begin with any word but a mark.
bool has_stl_length(std::string_view bytes) { return is_binary_stl(bytes) && !has_mark(bytes); }

bool is_gltf(std::string_view bytes) {
  return is_json(bytes) && bytes.find("\"asset\"") != bytes.npos && !has_stl_length(bytes);
}
bool is_mni_text(std::string_view bytes) { return is_mni(bytes) && !has_stl_length(bytes); }

/// The first word, which tells the other texts apart; empty if a mark or the length already decides the format.
std::string keyword(std::string_view bytes) {
  return has_mark(bytes) || has_stl_length(bytes) ? std::string() : first_word(bytes);
}

bool is_off(std::string_view bytes) { return is_off_keyword(keyword(bytes)); }
bool is_stl(std::string_view bytes) { return has_stl_length(bytes) || to_lower(keyword(bytes)) == "solid"; }
bool is_obj(std::string_view bytes) {
  constexpr std::array<std::string_view, 11> kStatements = {"v", "vn",     "vt",     "vp", "f", "o",
                                                            "g", "mtllib", "usemtl", "s",  "l"};
  return std::ranges::find(kStatements, keyword(bytes)) != kStatements.end();
}

/// A reader for files that refer to no other files.
template <PolygonSoup (*parse)(std::string_view, std::string_view)>
PolygonSoup read_alone(std::string_view bytes, std::string_view name, const std::optional<std::filesystem::path>&) {
  return parse(bytes, name);
}

std::vector<Format> list_formats() {
  using enum Content;
  using Id = MeshFormat;
  return {
      {.id = Id::ply,
       .name = "ply",
       .title = "PLY",
       .extensions = {"ply"},
       .carries =
           surface | doubles | face_labels | vertex_labels | colors | face_numbers | distances | texture | properties,
       .is_binary = true,
       .is_content = is_ply,
       .read = read_alone<parse_ply>,
       .write = io::write_ply,
       .read_property = parse_ply_property,
       .read_properties = parse_ply_properties},
      {.id = Id::obj,
       .name = "obj",
       .title = "OBJ",
       .extensions = {"obj"},
       .carries = surface | doubles | face_labels | colors | curves | texture | materials,
       .is_content = is_obj,
       .read = read_alone<parse_obj>,
       .write = io::write_obj,
       .read_properties = parse_obj_colors},
      {.id = Id::off,
       .name = "off",
       .title = "OFF",
       .extensions = {"off"},
       .carries = surface | doubles,
       .is_content = is_off,
       .read = read_alone<parse_off>,
       .write = io::write_off},
      {.id = Id::coff,  // read as OFF
       .name = "coff",
       .extensions = {"coff"},
       .carries = surface | doubles | colors,
       .write = io::write_coff},
      {.id = Id::stl,
       .name = "stl",
       .title = "STL",
       .extensions = {"stl"},
       .carries = surface | colors,
       .is_binary = true,
       .is_content = is_stl,
       .read = read_alone<parse_stl>,
       .write = io::write_stl},
      {.id = Id::vtp,
       .name = "vtp",
       .title = "VTP",
       .extensions = {"vtp"},
       .carries = surface | doubles | face_labels | vertex_labels | face_numbers | distances | curves,
       .is_content = is_vtp,
       .read = read_alone<parse_vtk_xml>,
       .write = io::write_vtp,
       .read_property = parse_vtk_xml_property},
      {.id = Id::vtu,
       .name = "vtu",
       .title = "VTU",
       .extensions = {"vtu"},
       .carries = surface | doubles | face_labels | vertex_labels | face_numbers | distances | curves,
       .is_content = is_vtu,
       .read = read_alone<parse_vtk_xml>,
       .write = io::write_vtu,
       .read_property = parse_vtk_xml_property},
      {.id = Id::vtk,
       .name = "vtk",
       .title = "VTK",
       .extensions = {"vtk"},
       .carries = surface | doubles,
       .is_content = is_vtk,
       .read = read_alone<parse_vtk>},
      {.id = Id::glb,
       .name = "glb",
       .title = "GLB",
       .extensions = {"glb"},
       .carries = surface | place | face_labels | colors | curves | texture,
       .is_binary = true,
       .is_content = is_glb,
       .read = parse_gltf,
       .write = io::write_glb},
      {.id = Id::gltf,
       .name = "gltf",
       .title = "glTF",
       .extensions = {"gltf"},
       .carries = surface | place | texture,
       .is_content = is_gltf,
       .read = parse_gltf},
      {.id = Id::gii,
       .name = "gii",
       .title = "GIFTI",
       .extensions = {"surf.gii", "gii"},
       .carries = surface,
       .is_content = is_gifti,
       .read = read_alone<parse_gifti>,
       .write = io::write_gifti_surface},
      {.id = Id::label_gii,  // values are read by read_values.cpp
       .name = "label.gii",
       .extensions = {"label.gii"},
       .carries = vertex_labels | colors,
       .write = io::write_gifti_labels},
      {.id = Id::shape_gii,
       .name = "shape.gii",
       .extensions = {"shape.gii", "func.gii"},
       .carries = distances | rows,
       .write = io::write_gifti_distances},
      {.id = Id::mni,  // its files are called .obj
       .name = "mni",
       .title = "MNI",
       .extensions = {},
       .carries = surface | doubles,
       .is_content = is_mni_text,
       .read = read_alone<parse_mni>},
      {.id = Id::fs,
       .name = "fs",
       .title = "FreeSurfer",
       .extensions = {"fs"},
       .carries = surface,
       .is_binary = true,
       .input_extensions = {"white", "pial", "inflated", "sphere", "orig"},
       .is_content = is_freesurfer,
       .read = read_alone<parse_freesurfer>,
       .write = io::write_freesurfer_surface},
      {.id = Id::annot,
       .name = "annot",
       .extensions = {"annot"},
       .carries = vertex_labels | colors,
       .is_binary = true,
       .write = io::write_annotation},
      {.id = Id::curv,
       .name = "curv",
       .extensions = {"curv"},
       .carries = distances,
       .is_binary = true,
       .write = io::write_freesurfer_distances},
      {.id = Id::json,
       .name = "json",
       .extensions = {"json"},
       .carries = diagram | rows | targets | paths | isolines | generators,
       .write = io::write_diagram},
      {.id = Id::npy, .name = "npy", .extensions = {"npy"}, .carries = rows | targets, .is_binary = true},
      {.id = Id::csv, .name = "csv", .extensions = {"csv"}, .carries = rows | targets | paths | generators},
      {.id = Id::txt, .name = "txt", .extensions = {"txt"}, .carries = rows | targets | generators},
  };
}

}  // namespace

const std::vector<Format>& formats() {
  static const std::vector<Format> table = list_formats();
  return table;
}

const Format& format_row(MeshFormat format) { return formats()[static_cast<std::size_t>(format)]; }

Choices<MeshFormat> input_format_names() {
  Choices<MeshFormat> names;
  for (const Format& format : formats()) {
    if (format.read != nullptr) names.emplace_back(format.name, format.id);
  }
  return names;
}

const Format* find_output(std::string_view extension) {
  const std::string wanted = io::bare_extension(extension);
  for (const Format& format : formats()) {
    if (format.is_output() && std::ranges::find(format.extensions, wanted) != format.extensions.end()) return &format;
  }
  return nullptr;
}

std::vector<std::string> output_extensions(Content any, Content none) {
  std::vector<std::string> extensions;
  for (const Format& format : formats()) {
    const bool is_wanted = has_any(format.carries, any) && !has_any(format.carries, none);
    if (format.is_output() && is_wanted) extensions.push_back(format.extensions.front());
  }
  return extensions;
}

namespace {

std::vector<std::string> dotted(std::vector<std::string> extensions) {
  for (std::string& extension : extensions) extension = '.' + extension;
  return extensions;
}

}  // namespace

std::string list_extensions(const std::vector<std::string>& extensions, std::string_view last) {
  return join_words(dotted(extensions), last);
}

std::string only_formats(Content any, const std::vector<std::string>& others) {
  std::vector<std::string> holders = dotted(output_extensions(any));
  holders.insert(holders.end(), others.begin(), others.end());
  return fmt::format("only {} {}", join_words(holders, "and"), holders.size() == 1 ? "holds" : "hold");
}

}  // namespace gvd
