// Reads Wavefront OBJ: the statements v, vt, f, usemtl and mtllib in one pass over the lines, and colours of vertices,
// which few files have, in another pass.
//
// A face may refer to vertices that come later in the file. Such references are kept and checked at the end, so that a
// message names the line of the face. Indices are 1-based, or negative and counted back from the last vertex so far.
// Groups, normals and curves are skipped; free-form surfaces (NURBS) are skipped with a note. Wrong numbers of a
// texture are only noted and not refused, because the surface is complete without them.
// Source: Wavefront's Advanced Visualizer manual, appendix B1.
// Invariant: every stored index fits into 32 bits, whatever the file says.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "gvd/text.hpp"
#include "mesh/reading/readers.hpp"

namespace gvd {
namespace {

/// A face that refers to a vertex later in the file, which the format allows.
struct ForwardReference {
  std::int64_t polygon, index, line;
};

/// Joins a line that ends in a backslash with the next line. `joined` holds the text of the joined lines.
void join_continued_lines(TextReader& text, std::string& joined) {
  const auto continued = [](std::string_view line) {
    while (line.ends_with('\r') || line.ends_with(' ') || line.ends_with('\t')) line.remove_suffix(1);
    return line.ends_with('\\') && line.find('#') == std::string_view::npos;
  };
  if (!continued(text.line())) return;
  joined.clear();
  bool more = true;
  do {
    joined += text.line();
    more = continued(text.line());
    if (more) joined[joined.rfind('\\')] = ' ';
    joined += ' ';
  } while (more && text.next_line());
  text.replace_line(joined);
}

class ObjParser {
 public:
  ObjParser(std::string_view bytes, std::string_view name) : text_(bytes, name, true) {
    // A vertex line has at least about 30 bytes, a face line about 20. The vectors grow if this is too little.
    soup_.positions.reserve(bytes.size() / 100);
    soup_.corners.reserve(bytes.size() / 20);
    soup_.first_corner.reserve(bytes.size() / 60);
  }

  LineSoup parse_lines() {
    lines_wanted_ = true;
    parse();
    return {std::move(soup_.positions), std::move(edges_)};
  }

  PolygonSoup parse() {
    while (text_.next_content_line()) {
      const std::string_view line = text_.line();
      const std::size_t begin = line.find_first_not_of(" \t\v\f");
      const char first = begin == std::string_view::npos ? '\0' : line[begin];
      if (first != 'v' && first != 'f' && first != 'l' && first != 'u' && first != 'm' && first != 's') continue;
      if (first == 'v' || first == 'f' || (first == 'l' && lines_wanted_)) join_continued_lines(text_, joined_);
      read_statement(text_.token());
    }
    check_forward_references();
    finish_texture();
    use_material("");  // assigns the last material to the last polygons
    if (materials_.empty()) soup_.appearance.material.clear();
    if (lines_wanted_) return {};
    if (lines_ > 0)
      soup_.notes.push_back(fmt::format("{} (statement l) left out", counted(lines_, "polyline", "polylines")));
    if (free_surfaces_ > 0) {
      soup_.notes.push_back(fmt::format("{} (statement surf) left out; export the surface as triangles",
                                        counted(free_surfaces_, "free-form surface", "free-form surfaces")));
    }
    return std::move(soup_);
  }

 private:
  void read_statement(std::string_view statement) {
    if (statement == "v") {
      soup_.positions.push_back(text_.position(soup_.positions.size()));
    } else if (statement == "vt") {
      const std::optional<double> u = parse_double(text_.token());
      const std::string_view v = text_.token();  // v is 0 if it is missing
      texture_vertices_.push_back({u.value_or(kNone), v.empty() ? 0 : parse_double(v).value_or(kNone)});
    } else if (statement == "f") {
      if (!lines_wanted_) add_face();
    } else if (statement == "l") {
      ++lines_;
      if (lines_wanted_) add_line();
    } else if (statement == "surf") {
      ++free_surfaces_;
    } else if (statement == "usemtl") {
      use_material(rest_of_line());
    } else if (statement == "mtllib") {
      soup_.appearance.material_files.push_back(rest_of_line());
    }
  }

  void add_face() {
    for (std::string_view token = text_.token(); !token.empty(); token = text_.token()) {
      soup_.corners.push_back(vertex_index(token));
    }
    soup_.close_polygon();
  }

  /// Reads `l v v v ...`: an edge from each vertex to the next one.
  void add_line() {
    std::int32_t last = -1;
    for (std::string_view token = text_.token(); !token.empty(); token = text_.token()) {
      const std::int32_t next = vertex_index(token);
      if (last >= 0) edges_.push_back({last, next});
      last = next;
    }
  }

  /// The 0-based vertex of a corner `v`, `v/vt`, `v//vn` or `v/vt/vn`.
  std::int32_t vertex_index(std::string_view token) {
    const std::size_t slash = token.find('/');
    if (slash != token.npos) add_texture_number(token.substr(slash + 1));
    const std::int64_t polygon = soup_.polygon_count();
    const std::optional<std::int64_t> given = parse_integer(token.substr(0, slash));
    const bool tail_fits =
        slash == std::string_view::npos || token.find_first_not_of("0123456789+-/", slash) == std::string_view::npos;
    if (!given || !tail_fits)
      text_.refuse(fmt::format("{} is not a corner of a {}", quoted(token), element()), polygon);
    const std::int64_t count = std::ssize(soup_.positions);
    const std::int64_t index = *given > 0 ? *given - 1 : count + *given;
    if (*given == 0 || index < 0 || index >= kMostVertices) refuse_index(*given, count, polygon);
    if (index >= count) forward_.push_back({polygon, *given, text_.line_number()});
    return static_cast<std::int32_t>(index);
  }

  /// Stores the texture vertex of the next corner. `token` is the text after `v/`.
  void add_texture_number(std::string_view token) {
    token = token.substr(0, token.find('/'));
    if (token.empty()) return;
    const std::int64_t given = parse_integer(token).value_or(0);
    const std::int64_t index = given > 0 ? given - 1 : std::ssize(texture_vertices_) + given;
    texture_numbers_.resize(soup_.corners.size(), kNoNumber);
    const bool is_number = given != 0 && index >= 0 && index < kWrongNumber;
    texture_numbers_.push_back(is_number ? static_cast<std::int32_t>(index) : kWrongNumber);
  }

  /// Replaces the corners' texture numbers by coordinates. This comes after the last line, because the coordinates may
  /// be later in the file than the faces. If no corner has coordinates, the soup gets no texture.
  void finish_texture() {
    if (texture_numbers_.empty()) return;
    texture_numbers_.resize(soup_.corners.size(), kNoNumber);
    std::int64_t known = 0, wrong = 0;
    for (const std::int32_t number : texture_numbers_) {
      const bool is_listed = number >= 0 && number < std::ssize(texture_vertices_);
      const Uv& uv = soup_.appearance.texture.emplace_back(is_listed ? texture_vertices_[number] : kNoTexture);
      ++(is_finite(uv) ? known : wrong);
      if (number == kNoNumber) --wrong;
    }
    if (known == 0) soup_.appearance.texture.clear();
    if (wrong == 0) return;
    soup_.notes.push_back(fmt::format("{} to texture coordinates that are missing or no numbers: left out",
                                      counted(wrong, "corner refers", "corners refer")));
  }

  /// The name after the statement, which may contain blanks and '#'.
  std::string rest_of_line() const {
    const std::string_view rest = text_.line();
    const std::size_t begin = std::min(rest.find_first_not_of(" \t"), rest.size());
    return std::string(rest.substr(begin, rest.find_last_not_of(" \t\r") + 1 - begin));
  }

  /// Sets the material of the polygons that follow.
  void use_material(const std::string& name) {
    soup_.appearance.material.resize(soup_.polygon_count(), material_);
    material_ = -1;
    if (name.empty() || name == kNoMaterial) return;
    const auto [known, is_new] = materials_.try_emplace(name, std::int32_t(materials_.size()));
    if (is_new) soup_.appearance.materials.push_back(name);
    material_ = known->second;
  }

  const char* element() const { return lines_wanted_ ? "line" : "face"; }

  [[noreturn]] void refuse_index(std::int64_t given, std::int64_t count, std::int64_t polygon) const {
    if (given == 0) text_.refuse(fmt::format("a {} refers to vertex 0, and OBJ counts from 1", element()), polygon);
    text_.refuse(fmt::format("a {} refers to vertex {}, and there are {} before it", element(), given, count), polygon);
  }

  void check_forward_references() {
    const std::int64_t count = std::ssize(soup_.positions);
    for (const ForwardReference& reference : forward_) {
      if (reference.index <= count) continue;
      text_.skip_line_numbers(reference.line - text_.line_number());
      text_.refuse(fmt::format("a {} refers to vertex {}, and the file has {}", element(), reference.index, count),
                   reference.polygon);
    }
  }

  TextReader text_;
  PolygonSoup soup_;
  std::vector<ForwardReference> forward_;
  std::string joined_;
  std::int64_t lines_ = 0, free_surfaces_ = 0;
  bool lines_wanted_ = false;  // whether to read lines instead of faces
  std::vector<std::array<std::int32_t, 2>> edges_;
  static constexpr double kNone = kNoTexture[0];
  static constexpr std::int32_t kNoNumber = -1, kWrongNumber = std::numeric_limits<std::int32_t>::max();
  std::vector<Uv> texture_vertices_;
  std::vector<std::int32_t> texture_numbers_;  // of the corners, up to the last corner with a number
  std::map<std::string, std::int32_t> materials_;
  std::int32_t material_ = -1;  // the material of the next polygon
};

/// Reads the colours of vertices, from numbers after their coordinates or from comments.
///
/// MeshLab, Metashape and Blender write `v x y z r g b` with numbers from 0 to 1, other programs write numbers from 0
/// to 255, and MeshLab also writes an alpha. The range is decided for the whole file by its largest number, because a
/// single dark colour of 0 to 255 may have no number above 1. Computed numbers can leave their range by rounding
/// (1.0000001), so there is a tolerance, and numbers beyond the end of a range are clamped to it. A single number after
/// the coordinates is the weight of a curve's point. Numbers farther below 0 or above 255 are not colours (they may be
/// normals), and then no vertex has a colour. ZBrush writes `#MRGB` and eight digits for each vertex: a mask, red,
/// green and blue.
class ObjColorParser {
 public:
  ObjColorParser(std::string_view bytes, std::string_view name) : text_(bytes, name, false) {}

  std::vector<MeshProperty> parse() {
    while (text_.next_content_line()) {
      const std::string_view statement = text_.token();
      if (statement == "v") {
        join_continued_lines(text_, joined_);
        read_vertex();
      } else if (statement == "#MRGB") {
        read_masked();
      }
    }
    if (are_colors_ && largest_ > kNone) return make_properties(colors_, largest_ <= 1 + kBeyond ? kMost : 1);
    if (!masked_.empty() && masked_.size() == colors_.size()) return make_properties(masked_, 1);
    return {};
  }

 private:
  using Color = std::array<double, 4>;
  static constexpr double kMost = 255, kNone = -1;  // a vertex without a colour is white
  /// How far numbers may leave their range. Absolute; it is half a step of 8 bits in the range from 0 to 1. Up to
  /// there, rounding to 8 bits gives the end of the range anyway, so clamping changes no colour.
  static constexpr double kBeyond = 0.5 / kMost;

  void read_vertex() {
    Color color{kNone, kNone, kNone, kNone};
    for (int i = 0; i < 3; ++i) text_.token();
    std::size_t count = 0;
    for (std::string_view token = text_.token(); !token.empty() && token[0] != '#'; token = text_.token()) {
      const double number = parse_double(token).value_or(kNone);
      if (count < color.size()) color[count] = number;
      ++count;
    }
    if (count != 3 && count != 4) {
      colors_.push_back({kNone, kNone, kNone, kNone});
      return;
    }
    for (std::size_t i = 0; i < count; ++i) {
      are_colors_ = are_colors_ && color[i] >= -kBeyond && color[i] <= kMost + kBeyond;
      color[i] = std::max(color[i], 0.0);
      largest_ = std::max(largest_, color[i]);
    }
    has_alpha_ = has_alpha_ || count == 4;
    colors_.push_back(color);
  }

  void read_masked() {
    const std::string_view digits = text_.token();
    constexpr std::size_t kDigits = 8;
    for (std::size_t at = 0; at + kDigits <= digits.size(); at += kDigits) {
      const auto rgb = parse_hexadecimal(digits.substr(at + 2, kDigits - 2));
      if (!rgb) return;
      masked_.push_back({double(*rgb >> 16), double(*rgb >> 8 & 0xFF), double(*rgb & 0xFF), kNone});
    }
  }

  static std::optional<std::uint32_t> parse_hexadecimal(std::string_view digits) {
    std::uint32_t value = 0;
    const char* const end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, value, 16);
    return error == std::errc() && stop == end ? std::optional(value) : std::nullopt;
  }

  std::vector<MeshProperty> make_properties(const std::vector<Color>& colors, double scale) const {
    std::vector<MeshProperty> made;
    for (const char* name : {"red", "green", "blue", "alpha"}) {
      const std::size_t channel = made.size();
      if (channel == 3 && !has_alpha_) break;
      MeshProperty property{name, NumberType::uint8, true, {}, {}, {}};
      property.values.reserve(colors.size());
      for (const Color& color : colors) {
        property.values.push_back(color[channel] < 0 ? kMost : std::min(std::round(scale * color[channel]), kMost));
      }
      made.push_back(std::move(property));
    }
    return made;
  }

  TextReader text_;
  std::string joined_;
  std::vector<Color> colors_, masked_;  // of vertices: from their lines, and from comments
  double largest_ = kNone;              // of all numbers
  bool are_colors_ = true, has_alpha_ = false;
};

}  // namespace

std::vector<MeshProperty> parse_obj_colors(std::string_view bytes, std::string_view name) {
  return ObjColorParser(bytes, name).parse();
}

PolygonSoup parse_obj(std::string_view bytes, std::string_view name) { return ObjParser(bytes, name).parse(); }

LineSoup parse_obj_lines(std::string_view bytes, std::string_view name) { return ObjParser(bytes, name).parse_lines(); }

}  // namespace gvd
