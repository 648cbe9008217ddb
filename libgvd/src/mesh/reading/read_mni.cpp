// Reads MNI's surfaces in text, as CIVET and other programs of the McConnell Brain Imaging Centre write them. Their
// files are called .obj, like Wavefront's.
//
// A file is a list of objects. An object of polygons consists of P, five numbers for its shading, its points, a normal
// for each point, its colours (one, or one for each polygon or point), the end of each polygon in the list of corners,
// and this list. Numbers are separated by any blanks and line ends. The reader stops at an object of another kind
// (lines, markers), because it does not know the object's length, and notes that.
// Source: D. MacDonald, MNI Object File Formats; the reader of bicpl.
// Invariant: each count is compared with the number of remaining bytes before memory is reserved for it.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "gvd/text.hpp"
#include "mesh/reading/readers.hpp"

namespace gvd {
namespace {

constexpr int kSurfaceNumbers = 5;

constexpr std::int64_t kColorNumbers = 4;

/// Upper bound on the remaining numbers, each of which has at least a digit and a blank.
std::uint64_t most_numbers(const TextReader& text) { return (text.line().size() + text.remaining() + 2) / 2; }

/// Reads a count of elements that take at least `numbers` numbers each.
std::int64_t read_mni_count(TextReader& text, std::string_view what, std::uint64_t numbers) {
  const std::int64_t count = text.integer(what);
  if (count < 0 || std::uint64_t(count) > most_numbers(text) / numbers) {
    text.refuse(fmt::format("{} is {}, and the file has only {}", what, count,
                            counted(std::int64_t(text.remaining()), "more byte", "more bytes")));
  }
  return count;
}

/// Reads an object of polygons after its P.
void read_mni_polygons(TextReader& text, std::string_view name, PolygonSoup& soup) {
  const auto skip_numbers = [&](std::int64_t count, std::string_view what) {
    for (std::int64_t i = 0; i < count; ++i) text.number(what);
  };
  skip_numbers(kSurfaceNumbers, "a number of the surface");
  const std::int64_t points = read_mni_count(text, "the number of points", 3), first = std::ssize(soup.positions);
  check_counts(std::uint64_t(first + points), 0, name);
  // Reserving again for each of many objects would take quadratic time.
  if (first == 0) soup.positions.reserve(std::size_t(points));
  for (std::int64_t i = 0; i < points; ++i) soup.positions.push_back(text.position(first + i));
  skip_numbers(3 * points, "a number of a normal");
  const std::int64_t polygons = read_mni_count(text, "the number of polygons", 1);
  const std::int64_t kind = text.integer("the kind of colours");
  if (kind < 0 || kind > 2) text.refuse(fmt::format("the kind of colours is {}, and should be 0, 1 or 2", kind));
  skip_numbers(kColorNumbers * std::array<std::int64_t, 3>{1, polygons, points}[std::size_t(kind)], "a colour");
  std::vector<std::int64_t> ends;  // for each polygon, the number of corners up to its end
  ends.reserve(std::size_t(polygons));
  std::int64_t last = 0;
  for (std::int64_t p = 0; p < polygons; ++p) {
    const std::int64_t end = text.integer("the end of a polygon");
    if (end < last || std::uint64_t(end) > most_numbers(text) + std::uint64_t(last)) {
      text.refuse(fmt::format("polygon {} ends at corner {}, and the one before at {}", p, end, last), p);
    }
    ends.push_back(last = end);
  }
  std::int64_t corner = 0;
  for (const std::int64_t end : ends) {
    for (; corner < end; ++corner) {
      const std::int64_t v = text.integer("a corner of a polygon");
      if (v < 0 || v >= points) {
        text.refuse(fmt::format("polygon {} refers to point {}, and there are {}", soup.polygon_count(), v, points),
                    std::int64_t(soup.polygon_count()));
      }
      soup.corners.push_back(static_cast<std::int32_t>(first + v));
    }
    soup.close_polygon();
  }
}

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

PolygonSoup parse_mni(std::string_view bytes, std::string_view name) {
  TextReader text(bytes, name, false);
  PolygonSoup soup;
  while (text.begin_element()) {
    const std::string_view kind = text.token();
    if (kind == "P") {
      read_mni_polygons(text, name, soup);
      continue;
    }
    if (soup.polygon_count() == 0) {
      text.refuse(fmt::format("an object of MNI should begin with P, and not with {}", quoted(kind)));
    }
    soup.notes.push_back(fmt::format("line {}: {} is not an object of polygons; it and everything after it are skipped",
                                     text.line_number(), quoted(kind)));
    break;
  }
  return soup;
}

}  // namespace gvd
