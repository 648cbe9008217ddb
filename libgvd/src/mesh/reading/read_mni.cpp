// MNI's surfaces in text, as CIVET and other programs of the McConnell Brain Imaging Centre write them. Their files are
// called .obj, as Wavefront's are.
//
// A file is a row of objects. One of polygons is P, how it shines (five numbers), its points, a normal for each point,
// its colours (one, or one for each polygon or point), the end of each polygon in the list of corners, and this list.
// Numbers stand between blanks and line ends, wherever these are. Objects of other kinds (lines, markers) end the
// reading, since their length is not known; a note says so.
// Source: D. MacDonald, MNI Object File Formats; the reader of bicpl.
// Invariant: counts are compared with the bytes that are left before they reserve memory.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "gvd/text.hpp"
#include "mesh/reading/readers.hpp"

namespace gvd {
namespace {

constexpr int kSurfaceNumbers = 5;

class MniParser {
 public:
  MniParser(std::string_view bytes, std::string_view name) : text_(bytes, name, false), name_(name) {}

  PolygonSoup parse() {
    while (text_.begin_element()) {
      const std::string_view kind = text_.token();
      if (kind != "P") {
        if (soup_.polygon_count() == 0)
          text_.refuse(fmt::format("an object of MNI should begin with P, and not with {}", quoted(kind)));
        soup_.notes.push_back(
            fmt::format("line {}: {} is no polygons; left out, with what follows", text_.line_number(), quoted(kind)));
        break;
      }
      read_polygons();
    }
    return std::move(soup_);
  }

 private:
  void read_polygons() {
    skip_numbers(kSurfaceNumbers, "a number of the surface");
    const std::int64_t points = read_count("the number of points", 3), first = std::ssize(soup_.positions);
    check_counts(std::uint64_t(first + points), 0, name_);
    if (first == 0) soup_.positions.reserve(std::size_t(points));  // again for each of many objects would be quadratic
    for (std::int64_t i = 0; i < points; ++i) soup_.positions.push_back(text_.position(first + i));
    skip_numbers(3 * points, "a number of a normal");
    const std::int64_t polygons = read_count("the number of polygons", 1);
    skip_colors(points, polygons);
    read_corners(read_ends(polygons), points, first);
  }

  void skip_colors(std::int64_t points, std::int64_t polygons) {
    constexpr std::int64_t kChannels = 4;
    const std::int64_t kind = text_.integer("the kind of colours");
    if (kind < 0 || kind > 2) text_.refuse(fmt::format("the kind of colours is {}, and should be 0, 1 or 2", kind));
    skip_numbers(kChannels * std::array<std::int64_t, 3>{1, polygons, points}[std::size_t(kind)], "a colour");
  }

  /// The number of corners of all polygons up to each one.
  std::vector<std::int64_t> read_ends(std::int64_t polygons) {
    std::vector<std::int64_t> ends;
    ends.reserve(std::size_t(polygons));
    std::int64_t last = 0;
    for (std::int64_t p = 0; p < polygons; ++p) {
      const std::int64_t end = text_.integer("the end of a polygon");
      if (end < last || std::uint64_t(end) > most_numbers() + std::uint64_t(last)) {
        text_.refuse(fmt::format("polygon {} ends at corner {}, and the one before at {}", p, end, last), p);
      }
      ends.push_back(last = end);
    }
    return ends;
  }

  void read_corners(const std::vector<std::int64_t>& ends, std::int64_t points, std::int64_t first) {
    std::int64_t corner = 0;
    for (const std::int64_t end : ends) {
      for (; corner < end; ++corner) {
        const std::int64_t v = text_.integer("a corner of a polygon");
        if (v < 0 || v >= points) {
          text_.refuse(fmt::format("polygon {} refers to point {}, and there are {}", soup_.polygon_count(), v, points),
                       std::int64_t(soup_.polygon_count()));
        }
        soup_.corners.push_back(static_cast<std::int32_t>(first + v));
      }
      soup_.close_polygon();
    }
  }

  void skip_numbers(std::int64_t count, std::string_view what) {
    for (std::int64_t i = 0; i < count; ++i) text_.number(what);
  }

  /// Upper bound on the numbers that are left: each has a digit and a blank.
  std::uint64_t most_numbers() const { return (text_.line().size() + text_.remaining() + 2) / 2; }

  /// A number of elements, each of which takes some numbers.
  std::int64_t read_count(std::string_view what, std::uint64_t numbers) {
    const std::int64_t count = text_.integer(what);
    if (count < 0 || std::uint64_t(count) > most_numbers() / numbers) {
      text_.refuse(fmt::format("{} is {}, and the file has only {}", what, count,
                               counted(std::int64_t(text_.remaining()), "more byte", "more bytes")));
    }
    return count;
  }

  TextReader text_;
  std::string name_;
  PolygonSoup soup_;
};

}  // namespace

bool is_mni(std::string_view bytes) {
  constexpr std::size_t kSearched = 4096;
  TextReader text(bytes.substr(0, kSearched), "", false);
  if (!text.next_content_line() || text.token() != "P") return false;
  for (int i = 0; i < kSurfaceNumbers; ++i) {
    if (!parse_double(text.token())) return false;
  }
  return parse_integer(text.token()).has_value();
}

PolygonSoup parse_mni(std::string_view bytes, std::string_view name) { return MniParser(bytes, name).parse(); }

}  // namespace gvd
