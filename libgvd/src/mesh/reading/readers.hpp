#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gvd/mesh_property.hpp"
#include "gvd/polygon_soup.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// The advice about a damaged file, in messages of readers.
inline constexpr const char* kExportAgain = "export the file again";

/// The double nearest to a decimal number, the same in any locale: "1", "+1.5", "-2e-3", "nan", "inf". A number that is
/// too small for a double is 0, one that is too large is infinity. None where the token is anything else.
std::optional<double> parse_double(std::string_view token);

/// A decimal integer with an optional sign; none where the token is anything else or beyond 64 bits.
std::optional<std::int64_t> parse_integer(std::string_view token);

/// Reads a text line by line and token by token, and keeps the line number for messages.
class TextReader {
 public:
  /// Lines end in LF, CR LF or CR. With `comments`, the rest of a line from '#' on is skipped.
  TextReader(std::string_view bytes, std::string_view name, bool comments);
  TextReader(const TextReader&) = delete;
  TextReader& operator=(const TextReader&) = delete;

  /// Moves to the next line, or to the next line with a token. False at the end of the text.
  bool next_line();
  bool next_content_line();
  /// Moves to the next line with a token, where an element begins. Its numbers may continue on the next lines. False at
  /// the end of the text.
  bool begin_element();
  /// Refuses an element that continued on another line and does not end with that line: a number was missing, and the
  /// next element's numbers were read instead. `kind` and `element` are for messages.
  void end_element(std::string_view kind, std::int64_t element) const;
  /// The next token of the line; empty at its end.
  std::string_view token();
  /// Numbers the next lines as if `count` more lines came before them.
  void skip_line_numbers(std::int64_t count) { line_number_ += count; }

  /// The next token of the line, or of the element that has begun, as a number. Throws Error{unreadable_input} where it
  /// is missing or no number. `what` names it in the message.
  double number(std::string_view what);
  std::int64_t integer(std::string_view what);
  /// Three coordinates. Throws Error{precondition} where one is not finite. `vertex` is for messages.
  Vec3 position(std::int64_t vertex);

  std::string_view line() const { return line_; }
  /// Characters that are not read yet.
  std::size_t remaining() const { return text_.size(); }
  std::int64_t line_number() const { return line_number_; }
  /// Replaces the rest of the current line by another text, which must outlive its use.
  void replace_line(std::string_view line) { line_ = line; }

  /// Throws Error{unreadable_input}: "name:line: message".
  [[noreturn]] void refuse(const std::string& message, std::int64_t element = -1) const;
  /// Throws Error{unreadable_input} about the end of the file.
  [[noreturn]] void refuse_end(const std::string& message, std::int64_t element = -1) const;

 private:
  std::string_view next_number(std::string_view what);

  std::string unix_text_;  // a copy with LF for CR, if the text has lines that end in CR
  std::string_view text_;  // what is left after the current line
  std::string_view line_;  // what is left of the current line
  std::string name_;
  bool comments_;
  std::int64_t line_number_ = 0;
  std::int64_t element_line_ = 0;  // where the element begins; 0 outside of elements
};

// The readers of the formats. `bytes` is a whole file and `name` stands for it in messages. Errors, properties and
// cost are those of `parse_soup`.

/// Wavefront OBJ: the statements `v`, `vt`, `f`, `usemtl` and `mtllib`; all others are skipped.
PolygonSoup parse_obj(std::string_view bytes, std::string_view name);

/// The colours of an OBJ's vertices as `red`, `green`, `blue` and, where a vertex has one, `alpha`, of 8 bits; nothing
/// where it has none. They stand behind the coordinates (`v x y z r g b [a]`) or in ZBrush's comments `#MRGB`.
/// docs/guide/input.md tells which numbers count as colours.
std::vector<MeshProperty> parse_obj_colors(std::string_view bytes, std::string_view name);

/// Points, and edges between them by their indices.
struct LineSoup {
  std::vector<Vec3> positions;
  std::vector<std::array<std::int32_t, 2>> edges;
};

/// The polylines of an OBJ, from `v` and `l`; and those of a PLY, from its elements `vertex` and `edge`.
LineSoup parse_obj_lines(std::string_view bytes, std::string_view name);
LineSoup parse_ply_lines(std::string_view bytes, std::string_view name);

/// PLY, text and binary: the elements `vertex` and `face`. Other elements, and properties but those of a texture, are
/// skipped.
PolygonSoup parse_ply(std::string_view bytes, std::string_view name);

/// One property of the element `vertex` or `face` that is a number, first of the preferred one: none where there is no
/// such property.
std::optional<SoupProperty> parse_ply_property(std::string_view bytes, std::string_view property, std::string_view name,
                                               SoupElement preferred);

/// The properties of a PLY, as read_mesh_properties returns them.
std::vector<MeshProperty> parse_ply_properties(std::string_view bytes, std::string_view name);

/// The numbers of a PLY's vertices, coordinates among them, without lists: nothing else of the file is needed.
std::vector<MeshProperty> parse_ply_vertices(std::string_view bytes, std::string_view name);

/// Geomview's OFF in text, with or without colours, normals and texture coordinates, which are skipped. Each vertex and
/// each face begins a line, or all numbers are on the line of the counts.
PolygonSoup parse_off(std::string_view bytes, std::string_view name);

/// Whether a word is the keyword of an OFF file: OFF, COFF, NOFF, STCNOFF, 4OFF, nOFF and so on, also with the number
/// of vertices right behind it.
bool is_off_keyword(std::string_view word);

/// STL, binary and text: triangles with vertices of their own.
PolygonSoup parse_stl(std::string_view bytes, std::string_view name);

/// VTK's PolyData (.vtp) and UnstructuredGrid (.vtu) in XML, whatever its name: points, polygons and strips; lines,
/// vertices and all data of points and cells are skipped. Text, Base64 and appended arrays, plain or compressed by
/// zlib.
PolygonSoup parse_vtk_xml(std::string_view bytes, std::string_view name);

/// One array of CellData or PointData of such a file that has a number for each cell or point, as numbers of the soup's
/// polygons or vertices, first of the preferred ones: of the name `property`, else of one that differs in upper and
/// lower case only. None where there is no such array.
std::optional<SoupProperty> parse_vtk_xml_property(std::string_view bytes, std::string_view property,
                                                   std::string_view name, SoupElement preferred);

/// Legacy files of VTK (.vtk), text and binary: PolyData, and unstructured grids whose cells are polygons.
PolygonSoup parse_vtk(std::string_view bytes, std::string_view name);

/// glTF 2.0, binary (.glb) or JSON (.gltf): the triangles of its scene, where the nodes' transforms put them, with the
/// first set of texture coordinates. Vertices are unwelded. Buffers may be files in `folder`, if there is one.
PolygonSoup parse_gltf(std::string_view bytes, std::string_view name,
                       const std::optional<std::filesystem::path>& folder = {});

/// The files beside a glTF that it refers to, buffers and images, as paths from its folder. Addresses that are not
/// read, such as those of the web, are left out.
std::vector<std::filesystem::path> list_gltf_files(std::string_view bytes, std::string_view name);

/// Whether a text begins with the brace of a JSON object.
bool is_json(std::string_view bytes);

/// The polygons of MNI's and CIVET's surfaces in text, whose files are called .obj, too. Normals and colours are
/// skipped.
PolygonSoup parse_mni(std::string_view bytes, std::string_view name);

/// Whether a file begins as MNI's polygons in text do: `P`, five numbers and the number of points.
bool is_mni(std::string_view bytes);

/// GIFTI: the points and triangles of a surface. Values, and transforms of coordinates, are left out and noted.
PolygonSoup parse_gifti(std::string_view bytes, std::string_view name);

/// FreeSurfer's surfaces of triangles; what follows the triangles is skipped.
PolygonSoup parse_freesurfer(std::string_view bytes, std::string_view name);

/// The first bytes of FreeSurfer's surfaces of triangles, and of its values of vertices.
inline constexpr std::string_view kFreeSurferSurface = "\xff\xff\xfe", kFreeSurferValues = "\xff\xff\xff";

/// The numbers of a GIFTI file that has one array of them, besides those of a surface.
std::vector<double> parse_gifti_values(std::string_view bytes, std::string_view name);

/// The values of vertices that FreeSurfer keeps in files such as lh.curv and lh.thickness.
std::vector<double> parse_morphometry(std::string_view bytes, std::string_view name);

/// The number of each vertex's region in the table of a FreeSurfer annotation; -1 where the table lacks its colour.
std::vector<double> parse_annotation(std::string_view bytes, std::string_view name);

/// Whether an XML document's first element is this one, given as "<NAME". It is looked for in the first kilobytes.
bool is_xml_of(std::string_view bytes, std::string_view element);

/// The first word of the first line that is neither blank nor a comment, within the first megabyte.
std::string first_word(std::string_view bytes);

/// All bytes of a file, unpacked if gzip packed them, and in UTF-8 if they are text in UTF-16. Throws
/// Error{unreadable_input} where that is not possible.
std::string read_file_bytes(const std::filesystem::path& path);

/// Whether the file has exactly the length that the triangle count in its header asks for.
bool is_binary_stl(std::string_view bytes);

inline constexpr std::int64_t kMostVertices = std::numeric_limits<std::int32_t>::max();

/// Throws Error{precondition} where there are more vertices or polygons than 32-bit ids can count.
void check_counts(std::uint64_t vertices, std::uint64_t polygons, std::string_view name);

}  // namespace gvd
