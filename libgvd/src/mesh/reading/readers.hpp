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

/// Parses a decimal number to the nearest double, in any locale: "1", "+1.5", "-2e-3", "nan", "inf". A number too small
/// for a double becomes 0, and a number too large becomes infinity. Returns nothing for any other token.
std::optional<double> parse_double(std::string_view token);

/// Parses a decimal integer with an optional sign; returns nothing for any other token and for integers beyond 64 bits.
std::optional<std::int64_t> parse_integer(std::string_view token);

/// Reads a text line by line and token by token, and keeps the line number for messages.
class TextReader {
 public:
  /// Lines end in LF, CR LF or CR. With `comments`, everything from '#' to the end of the line is skipped.
  TextReader(std::string_view bytes, std::string_view name, bool comments);
  TextReader(const TextReader&) = delete;
  TextReader& operator=(const TextReader&) = delete;

  /// Moves to the next line, or to the next line with a token. Returns false at the end of the text.
  bool next_line();
  bool next_content_line();
  /// Moves to the next line with a token, where an element begins, whose numbers may continue on the next lines.
  /// Returns false at the end of the text.
  bool begin_element();
  /// Refuses an element that continued on another line and does not end with that line, because a number was missing
  /// and numbers of the next element were read instead. `kind` and `element` are for messages.
  void end_element(std::string_view kind, std::int64_t element) const;
  /// The next token of the line; empty at its end.
  std::string_view token();
  /// Counts `count` more lines before the next line.
  void skip_line_numbers(std::int64_t count) { line_number_ += count; }

  /// Reads the next token of the line, or of the element that has begun, as a number. Throws Error{unreadable_input} if
  /// it is missing or not a number. `what` names it in the message.
  double number(std::string_view what);
  std::int64_t integer(std::string_view what);
  /// Reads three coordinates. Throws Error{precondition} if one is not finite. `vertex` is for messages.
  Vec3 position(std::int64_t vertex);

  std::string_view line() const { return line_; }
  /// Number of characters after the current line.
  std::size_t remaining() const { return text_.size(); }
  std::int64_t line_number() const { return line_number_; }
  /// Replaces the rest of the current line by another text, which must outlive its use.
  void replace_line(std::string_view line) { line_ = line; }

  /// Throws Error{unreadable_input} with "name:line: message".
  [[noreturn]] void refuse(const std::string& message, std::int64_t element = -1) const;
  /// Throws Error{unreadable_input} about the end of the file.
  [[noreturn]] void refuse_end(const std::string& message, std::int64_t element = -1) const;

 private:
  std::string_view next_number(std::string_view what);

  std::string unix_text_;  // a copy with LF in place of CR, if lines end in CR
  std::string_view text_;  // the text after the current line
  std::string_view line_;  // the rest of the current line
  std::string name_;
  bool comments_;
  std::int64_t line_number_ = 0;
  std::int64_t element_line_ = 0;  // the line on which the element begins; 0 outside of elements
};

// The readers of the formats. `bytes` is a whole file, which messages call `name`. Errors, properties and cost are the
// same as for `parse_soup`.

/// Reads Wavefront OBJ: the statements `v`, `vt`, `f`, `usemtl` and `mtllib`; all others are skipped.
PolygonSoup parse_obj(std::string_view bytes, std::string_view name);

/// Reads the colours of an OBJ's vertices as the properties `red`, `green`, `blue` and, if any vertex has one, `alpha`,
/// of 8 bits; returns nothing if the file has no colours. They follow the coordinates (`v x y z r g b [a]`) or are in
/// ZBrush's comments `#MRGB`. docs/guide/input.md tells which numbers count as colours.
std::vector<MeshProperty> parse_obj_colors(std::string_view bytes, std::string_view name);

/// Points, and edges between them by their indices.
struct LineSoup {
  std::vector<Vec3> positions;
  std::vector<std::array<std::int32_t, 2>> edges;
};

/// Reads the polylines of an OBJ, from `v` and `l`, or of a PLY, from its elements `vertex` and `edge`.
LineSoup parse_obj_lines(std::string_view bytes, std::string_view name);
LineSoup parse_ply_lines(std::string_view bytes, std::string_view name);

/// Reads PLY, text and binary: positions, faces and texture coordinates from the elements `vertex`, `face` and
/// `tristrips`. Other elements and properties are skipped.
PolygonSoup parse_ply(std::string_view bytes, std::string_view name);

/// Reads one property of the element `vertex` or `face` that is a number. If both have it, the preferred element wins;
/// returns nothing if neither has it.
std::optional<SoupProperty> parse_ply_property(std::string_view bytes, std::string_view property, std::string_view name,
                                               SoupElement preferred);

/// Reads the properties of a PLY, as `read_mesh_properties` returns them.
std::vector<MeshProperty> parse_ply_properties(std::string_view bytes, std::string_view name);

/// Reads all numbers of a PLY's vertices, including the coordinates, but no lists. The file needs no other element.
std::vector<MeshProperty> parse_ply_vertices(std::string_view bytes, std::string_view name);

/// Reads Geomview's OFF in text. Colours, normals and texture coordinates are skipped. Each vertex and each face begins
/// a line, or all numbers are on the line of the counts.
PolygonSoup parse_off(std::string_view bytes, std::string_view name);

/// Whether a word is the keyword of an OFF file: OFF, COFF, NOFF, STCNOFF, 4OFF, nOFF and so on. The number of vertices
/// may follow without a blank.
bool is_off_keyword(std::string_view word);

/// Reads STL, binary and text, as triangles with vertices of their own.
PolygonSoup parse_stl(std::string_view bytes, std::string_view name);

/// Reads VTK's PolyData (.vtp) and UnstructuredGrid (.vtu) in XML, with text, Base64 or appended arrays, plain or
/// compressed by zlib. Takes points, polygons and strips; lines, vertices and all data of points and cells are skipped.
PolygonSoup parse_vtk_xml(std::string_view bytes, std::string_view name);

/// Reads one array of CellData or PointData of such a file that has a number for each cell or point, as numbers of the
/// soup's polygons or vertices. The preferred element comes first. The array has the name `property` or, if there is
/// none, a name that differs only in case. Returns nothing if there is no such array.
std::optional<SoupProperty> parse_vtk_xml_property(std::string_view bytes, std::string_view property,
                                                   std::string_view name, SoupElement preferred);

/// Reads legacy files of VTK (.vtk), text and binary: PolyData, and unstructured grids whose cells are polygons.
PolygonSoup parse_vtk(std::string_view bytes, std::string_view name);

/// Reads glTF 2.0, binary (.glb) or JSON (.gltf): the triangles of its scene, placed by the nodes' transforms, with the
/// first set of texture coordinates. Vertices are unwelded. If `folder` is given, buffers may be files in it.
PolygonSoup parse_gltf(std::string_view bytes, std::string_view name,
                       const std::optional<std::filesystem::path>& folder = {});

/// Lists the files beside a glTF to which it refers for buffers and images, as paths relative to its folder. Addresses
/// that are not read, such as addresses of the web, are left out.
std::vector<std::filesystem::path> list_gltf_files(std::string_view bytes, std::string_view name);

/// Whether a text begins with the brace of a JSON object.
bool is_json(std::string_view bytes);

/// Reads the polygons of MNI's and CIVET's surfaces in text, whose files are also called .obj. Normals and colours are
/// skipped.
PolygonSoup parse_mni(std::string_view bytes, std::string_view name);

/// Whether a file begins like MNI's polygons in text: `P`, five numbers and the number of points.
bool is_mni(std::string_view bytes);

/// Reads the points and triangles of a GIFTI surface. Values and transforms of coordinates are skipped with a note.
PolygonSoup parse_gifti(std::string_view bytes, std::string_view name);

/// Reads FreeSurfer's surfaces of triangles, and skips everything after the triangles.
PolygonSoup parse_freesurfer(std::string_view bytes, std::string_view name);

/// The first bytes of FreeSurfer's surfaces of triangles, and of its values of vertices.
inline constexpr std::string_view kFreeSurferSurface = "\xff\xff\xfe", kFreeSurferValues = "\xff\xff\xff";

/// Reads the values of a GIFTI file, which must have exactly one array besides the arrays of a surface.
std::vector<double> parse_gifti_values(std::string_view bytes, std::string_view name);

/// Reads the values of vertices in FreeSurfer's files such as lh.curv and lh.thickness.
std::vector<double> parse_morphometry(std::string_view bytes, std::string_view name);

/// Reads a FreeSurfer annotation: for each vertex the number of its region in the table, or -1 if the table lacks its
/// colour.
std::vector<double> parse_annotation(std::string_view bytes, std::string_view name);

/// Whether the first element of an XML document is `element`, given as "<NAME". Looks only into the first kilobytes.
bool is_xml_of(std::string_view bytes, std::string_view element);

/// The first word of the first line that is neither blank nor a comment, within the first megabyte.
std::string first_word(std::string_view bytes);

/// Reads a file, unpacks it if it is compressed by gzip, and converts it to UTF-8 if it is text in UTF-16. Throws
/// Error{unreadable_input} if one of these fails.
std::string read_file_bytes(const std::filesystem::path& path);

/// Whether the length of the file is exactly the length that follows from the triangle count in its header.
bool is_binary_stl(std::string_view bytes);

inline constexpr std::int64_t kMostVertices = std::numeric_limits<std::int32_t>::max();

/// Throws Error{precondition} if there are more vertices or polygons than 32-bit ids can count.
void check_counts(std::uint64_t vertices, std::uint64_t polygons, std::string_view name);

}  // namespace gvd
