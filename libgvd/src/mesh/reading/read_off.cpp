// Reads Geomview's OFF in text: a keyword, the counts, then a line for each vertex and each face.
//
// The keyword is optional, and the counts may follow on its line, even without a blank: most files of ModelNet40 begin
// with "OFF642 1280 0". The numbers of an element may continue on the next lines; anything after them on the last line
// (a normal, a colour) is skipped. In a file with all numbers on the line of the counts, elements simply follow each
// other, and there can be no colours, which could not be told from the next element.
// Source: the Geomview manual, section OFF. Binary files and files of other dimensions are refused by their keyword.
// Invariant: each count is compared with the number of remaining bytes before memory is reserved for it.
#include <fmt/format.h>

#include "gvd/text.hpp"
#include "mesh/reading/readers.hpp"

namespace gvd {
namespace {

/// The part of a word before the digits at its end: the keyword without the number of vertices.
std::string_view without_count(std::string_view word) {
  return word.substr(0, word.find_last_not_of("0123456789") + 1);
}

class OffParser {
 public:
  OffParser(std::string_view bytes, std::string_view name) : text_(bytes, name, true) {}

  PolygonSoup parse() {
    read_header();
    if (is_one_line()) return parse_line();
    for (std::int64_t v = 0; v < vertices_; ++v) {
      if (!text_.begin_element()) refuse_end("vertex", v, vertices_);
      soup_.positions.push_back(text_.position(v));
      text_.end_element("vertex", v);
    }
    for (std::int64_t f = 0; f < faces_; ++f) {
      if (!text_.begin_element()) refuse_end("face", f, faces_);
      read_face(f);
      text_.end_element("face", f);
    }
    note_extra_lines();
    return std::move(soup_);
  }

 private:
  /// Whether all numbers of the vertices and faces follow on the line of the counts. Does not consume the line.
  bool is_one_line() {
    const std::string_view rest = text_.line();
    std::int64_t wanted = 1 + 3 * vertices_ + faces_;  // the number of edges; for a face at least its number of corners
    if (rest.size() < std::size_t(wanted)) return false;
    while (wanted > 0 && !text_.token().empty()) --wanted;
    text_.replace_line(rest);
    return wanted == 0;
  }

  PolygonSoup parse_line() {
    if (has_more_than_coordinates_) {
      text_.refuse(
          "colours, normals or texture coordinates can't be told from coordinates on one line; give each vertex "
          "and face a line of its own");
    }
    text_.integer("the number of edges");
    for (std::int64_t v = 0; v < vertices_; ++v) soup_.positions.push_back(text_.position(v));
    for (std::int64_t f = 0; f < faces_; ++f) read_face(f);
    if (const std::string_view more = text_.token(); !more.empty()) {
      text_.refuse(fmt::format(
          "{} follows the last face; if faces or vertices have colours, give each a line of its own", quoted(more)));
    }
    note_extra_lines();
    return std::move(soup_);
  }

  void read_header() {
    if (!text_.next_content_line()) text_.refuse_end("and holds no OFF header");
    const std::string_view line = text_.line();
    const std::string_view word = text_.token();
    if (is_off_keyword(word)) {
      const std::string_view keyword = without_count(word);
      check_keyword(keyword);
      has_more_than_coordinates_ = keyword != "OFF";
      if (keyword.starts_with("ST")) soup_.appearance.unread.emplace_back(kUnreadTexture);
      const std::string_view rest = line.substr(std::size_t(keyword.data() + keyword.size() - line.data()));
      text_.replace_line(rest);
      const std::string_view next = text_.token();
      if (next == "BINARY") text_.refuse("binary OFF is not supported; convert the file to text");
      if (!next.empty()) {
        text_.replace_line(rest);
      } else if (!text_.next_content_line()) {
        text_.refuse_end("and the counts of vertices and faces are missing");
      }
    } else if (!parse_integer(word)) {
      text_.refuse(fmt::format("the first line of an OFF file should be OFF, and is {}", quoted(line)));
    } else {
      text_.replace_line(line);
    }
    vertices_ = read_count("the number of vertices", 6);
    faces_ = read_count("the number of faces", 2);
    soup_.positions.reserve(vertices_);
    soup_.corners.reserve(3 * faces_);
    soup_.first_corner.reserve(faces_ + 1);
  }

  void check_keyword(std::string_view word) const {
    if (word.find_first_of("4n") != std::string_view::npos) {
      text_.refuse(fmt::format("{} has vertices that are not three-dimensional; it should be OFF", quoted(word)));
    }
  }

  /// Reads a count. The shortest lines of a vertex, "0 0 0", and of a face, "0", limit how many elements the rest of
  /// the file can hold. The last line may lack its line break.
  std::int64_t read_count(std::string_view what, std::size_t shortest_line) {
    const std::int64_t count = text_.integer(what);
    if (count < 0) text_.refuse(fmt::format("{} is {}", what, count));
    const std::size_t left = text_.line().size() + text_.remaining();
    if (std::uint64_t(count) > (left + 1) / shortest_line) {
      text_.refuse(fmt::format("{} is {}, and the file has only {}", what, count,
                               counted(std::int64_t(left), "more byte", "more bytes")));
    }
    return count;
  }

  void read_face(std::int64_t f) {
    const std::int64_t size = text_.integer("the number of corners");
    if (size < 0) text_.refuse(fmt::format("face {} has {}", f, counted(size, "corner", "corners")), f);
    for (std::int64_t i = 0; i < size; ++i) {
      const std::int64_t v = text_.integer("a corner of the face");
      if (v < 0 || v >= vertices_) {
        text_.refuse(fmt::format("face {} refers to vertex {}, and there are {}", f, v, vertices_), f);
      }
      soup_.corners.push_back(static_cast<std::int32_t>(v));
    }
    soup_.close_polygon();
  }

  [[noreturn]] void refuse_end(std::string_view what, std::int64_t next, std::int64_t promised) const {
    text_.refuse_end(fmt::format("and {} {} of {} is missing", what, next, promised), next);
  }

  void note_extra_lines() {
    std::int64_t lines = 0;
    while (text_.next_content_line()) ++lines;
    if (lines > 0)
      soup_.notes.push_back(fmt::format("{} after the last face left out", counted(lines, "line", "lines")));
  }

  TextReader text_;
  PolygonSoup soup_;
  std::int64_t vertices_ = 0;
  std::int64_t faces_ = 0;
  bool has_more_than_coordinates_ = false;  // whether vertices have more numbers, by the keyword
};

}  // namespace

bool is_off_keyword(std::string_view word) {
  word = without_count(word);
  if (!word.ends_with("OFF")) return false;
  word.remove_suffix(3);
  return word.find_first_not_of("STCN4n") == std::string_view::npos;
}

PolygonSoup parse_off(std::string_view bytes, std::string_view name) { return OffParser(bytes, name).parse(); }

}  // namespace gvd
