// Wavefront OBJ: the statements v, vt and f, in one pass over the lines.
//
// A face may refer to vertices that come later in the file. Such references are kept and checked at the end, so that a
// message names the line of the face. Indices are 1-based, or negative and counted back from the last vertex so far.
// Groups, normals, materials and curves are skipped. A texture is kept only where it is asked for.
// Source: Wavefront's Advanced Visualizer manual, appendix B1.
// Invariant: every index that was stored fits 32 bits, whatever the file says.
#include <fmt/format.h>

#include <array>
#include <limits>
#include <utility>

#include "gvd/text.hpp"
#include "mesh/reading/readers.hpp"

namespace gvd {
namespace {

/// A face that refers to a vertex which comes later in the file, as is legal.
struct ForwardReference {
  std::int64_t polygon, index, line;
};

class ObjParser {
 public:
  ObjParser(std::string_view bytes, std::string_view name) : text_(bytes, name, true) {
    // A vertex line has at least about 30 bytes, a face line about 20. The vectors grow where this is too little.
    soup_.positions.reserve(bytes.size() / 100);
    soup_.corners.reserve(bytes.size() / 20);
    soup_.first_corner.reserve(bytes.size() / 60);
  }

  std::optional<CornerTexture> parse_texture() {
    texture_.emplace();
    parse();
    bool is_used = false;
    for (const std::int64_t index : texture_numbers_) {
      const bool is_known = index >= 0 && index < std::ssize(texture_vertices_);
      constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
      is_used = is_used || is_known;
      texture_->coordinates.push_back(is_known ? texture_vertices_[index] : std::array<double, 2>{kNone, kNone});
    }
    if (!is_used) return std::nullopt;
    texture_->corners = std::move(soup_.corners);
    texture_->first_corner = std::move(soup_.first_corner);
    return std::move(texture_);
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
      if (first != 'v' && first != 'f' && first != 'l') continue;
      if (first != 'l' || lines_wanted_) join_continued_lines();
      const std::string_view statement = text_.token();
      if (statement == "v") {
        add_vertex();
      } else if (statement == "vt" && texture_) {
        add_texture_vertex();
      } else if (statement == "f") {
        if (!lines_wanted_) add_face();
      } else if (statement == "l") {
        ++lines_;
        if (lines_wanted_) add_line();
      }
    }
    check_forward_references();
    if (lines_ > 0 && !lines_wanted_)
      soup_.notes.push_back(fmt::format("{} (statement l) left out", counted(lines_, "polyline", "polylines")));
    return texture_ || lines_wanted_ ? PolygonSoup() : std::move(soup_);
  }

 private:
  /// Joins the next line to one that ends in a backslash.
  void join_continued_lines() {
    const auto continued = [](std::string_view line) {
      while (line.ends_with('\r') || line.ends_with(' ') || line.ends_with('\t')) line.remove_suffix(1);
      return line.ends_with('\\') && line.find('#') == std::string_view::npos;
    };
    if (!continued(text_.line())) return;
    joined_.clear();
    bool more = true;
    do {
      joined_ += text_.line();
      more = continued(text_.line());
      if (more) joined_[joined_.rfind('\\')] = ' ';
      joined_ += ' ';
    } while (more && text_.next_line());
    text_.replace_line(joined_);
  }

  void add_vertex() { soup_.positions.push_back(text_.position(soup_.positions.size())); }

  void add_face() {
    for (std::string_view token = text_.token(); !token.empty(); token = text_.token()) {
      soup_.corners.push_back(vertex_index(token));
      if (texture_) texture_numbers_.push_back(texture_number(token));
    }
    soup_.close_polygon();
  }

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
    if (slash != token.npos) soup_.has_texture |= slash + 1 < token.size() && token[slash + 1] != '/';
    const std::int64_t polygon = soup_.polygon_count();
    const std::optional<std::int64_t> given = parse_integer(token.substr(0, slash));
    const bool tail_fits =
        slash == std::string_view::npos || token.find_first_not_of("0123456789+-/", slash) == std::string_view::npos;
    if (!given || !tail_fits) text_.refuse(fmt::format("{} is no corner of a {}", quoted(token), element()), polygon);
    const std::int64_t count = std::ssize(soup_.positions);
    const std::int64_t index = *given > 0 ? *given - 1 : count + *given;
    if (*given == 0 || index < 0 || index >= kMostVertices) refuse_index(*given, count, polygon);
    if (index >= count) forward_.push_back({polygon, *given, text_.line_number()});
    return static_cast<std::int32_t>(index);
  }

  /// The 0-based number of the texture vertex of a corner; -1 for none.
  std::int64_t texture_number(std::string_view token) const {
    const std::size_t slash = token.find('/');
    if (slash == std::string_view::npos) return -1;
    token.remove_prefix(slash + 1);
    const std::int64_t given = parse_integer(token.substr(0, token.find('/'))).value_or(0);
    return given > 0 ? given - 1 : given < 0 ? std::ssize(texture_vertices_) + given : -1;
  }

  /// Reads `vt u v`; v is 0 where it is missing.
  void add_texture_vertex() {
    const double u = text_.number("u");
    const std::string_view v = text_.token();
    const std::optional<double> second = v.empty() ? 0.0 : parse_double(v);
    if (!second) text_.refuse(fmt::format("{} is no texture coordinate", quoted(v)));
    texture_vertices_.push_back({u, *second});
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
  std::int64_t lines_ = 0;
  bool lines_wanted_ = false;  // instead of faces
  std::vector<std::array<std::int32_t, 2>> edges_;
  std::optional<CornerTexture> texture_;  // only where it is wanted
  std::vector<std::array<double, 2>> texture_vertices_;
  std::vector<std::int64_t> texture_numbers_;  // per corner; outside of the texture vertices for none
};

}  // namespace

PolygonSoup parse_obj(std::string_view bytes, std::string_view name) { return ObjParser(bytes, name).parse(); }

LineSoup parse_obj_lines(std::string_view bytes, std::string_view name) { return ObjParser(bytes, name).parse_lines(); }

std::optional<CornerTexture> parse_obj_texture(std::string_view bytes, std::string_view name) {
  return ObjParser(bytes, name).parse_texture();
}

}  // namespace gvd
