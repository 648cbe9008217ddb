// Reads FreeSurfer's own formats: surfaces of triangles, annotations, and values of vertices ("morphometry", "curv").
//
// All numbers are big-endian. The first three bytes say what a file is, except that an annotation begins with a count.
// An annotation has a colour for each vertex, and a table in which the colour is the key of a region. Tables have two
// layouts; in the newer one, version 2, entries are numbered.
// Source: FreeSurfer's wiki, pages FileFormats and LabelsClutsAnnotationFiles; nibabel's freesurfer.io.
// Invariant: each count is compared with the number of remaining bytes before memory is reserved for it.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "gvd/error.hpp"
#include "gvd/text.hpp"
#include "mesh/reading/readers.hpp"
#include "mesh/reading/vtk_soup.hpp"

namespace gvd {
namespace {

constexpr StoredNumber kBigFloat{StoredNumber::Kind::real, 4, true};
constexpr StoredNumber kBigInteger{StoredNumber::Kind::signed_integer, 4, true};

class FreeSurferReader {
 public:
  FreeSurferReader(std::string_view bytes, std::string_view name) : bytes_(bytes), name_(name) {}

  std::int32_t integer(std::string_view what) { return std::int32_t(numbers(kBigInteger, 1, what)[0]); }

  /// Reads a count of elements that take at least `bytes` bytes each.
  std::uint64_t count(std::string_view what, std::uint64_t bytes) {
    const std::int32_t count = integer(what);
    if (count < 0 || std::uint64_t(count) * bytes > bytes_.size()) {
      refuse(fmt::format("{} is {}, and the file has only {}", what, count,
                         counted(std::ssize(bytes_), "more byte", "more bytes")));
    }
    return std::uint64_t(count);
  }

  std::vector<double> numbers(const StoredNumber& type, std::uint64_t count, std::string_view what) {
    if (count * type.size > bytes_.size()) refuse(fmt::format("the file ends before {}", what));
    return type.read_all(skip(count * type.size));
  }

  std::string_view skip(std::uint64_t count) {
    const std::string_view skipped = bytes_.substr(0, count);
    bytes_.remove_prefix(skipped.size());
    return skipped;
  }
  void skip_line() { skip(std::min(bytes_.find('\n'), bytes_.size()) + 1); }
  void skip_text(std::string_view what) { skip(count(what, 1)); }

  [[noreturn]] void refuse(std::string_view message) const {
    throw Error(ErrorCode::unreadable_input, fmt::format("{}: {}", name_, message));
  }

 private:
  std::string_view bytes_;  // not read yet
  std::string name_;
};

/// Reads an annotation's table: the number of each region, by its colour.
std::map<std::int32_t, std::int32_t> read_color_table(FreeSurferReader& in) {
  std::map<std::int32_t, std::int32_t> region;
  std::int32_t entries = in.integer("the table of regions");
  const bool is_numbered = entries < 0;
  if (is_numbered) {
    if (entries != -2)
      in.refuse(fmt::format("the table of regions has the version {}, and only 2 is read", -std::int64_t(entries)));
    in.integer("the largest number of a region");
  }
  in.skip_text("the length of a file's name");
  if (is_numbered) entries = in.integer("the number of regions");
  for (std::int32_t i = 0; i < entries; ++i) {
    const std::int32_t number = is_numbered ? in.integer("the number of a region") : i;
    in.skip_text("the length of a region's name");
    const std::vector<double> rgba = in.numbers(kBigInteger, 4, "the colour of a region");
    for (const double channel : rgba) {
      if (!(channel >= 0 && channel <= 255)) in.refuse(fmt::format("a colour of region {} is {}", number, channel));
    }
    region.emplace(std::int32_t(rgba[0] + 256 * rgba[1] + 65536 * rgba[2]), number);
  }
  return region;
}

}  // namespace

PolygonSoup parse_freesurfer(std::string_view bytes, std::string_view name) {
  FreeSurferReader in(bytes, name);
  const std::string_view mark = in.skip(3);
  if (mark == "\xff\xff\xfd" || mark == "\xff\xff\xff") {
    in.refuse(
        "the file is FreeSurfer's, with quads or with values; give a surface of triangles, as mris_convert makes");
  }
  if (mark != kFreeSurferSurface) in.refuse("the file does not begin as a FreeSurfer surface of triangles does");
  in.skip_line();  // skips the line that says who made the file, and a blank line
  in.skip_line();
  const std::uint64_t vertices = in.count("the number of vertices", 12), faces = in.count("the number of faces", 12);
  VtkSoup soup(name);
  soup.add_points(in.numbers(kBigFloat, 3 * vertices, "the last coordinate"));
  VtkCells cells{{}, in.numbers(kBigInteger, 3 * faces, "the last corner")};
  for (std::uint64_t f = 1; f <= faces; ++f) cells.ends.push_back(double(3 * f));
  soup.add_polygons(cells);
  return soup.take();
}

std::vector<double> parse_morphometry(std::string_view bytes, std::string_view name) {
  FreeSurferReader in(bytes, name);
  in.skip(3);
  const std::uint64_t vertices = in.count("the number of vertices", 4);
  in.integer("the number of faces");
  const std::int32_t values = in.integer("the number of values for each vertex");
  if (values != 1)
    in.refuse(fmt::format("the file has {} values for each vertex; give one with a single value", values));
  return in.numbers(kBigFloat, vertices, "the last value");
}

std::vector<double> parse_annotation(std::string_view bytes, std::string_view name) {
  FreeSurferReader in(bytes, name);
  const std::uint64_t vertices = in.count("the number of vertices", 8);
  const std::vector<double> pairs = in.numbers(kBigInteger, 2 * vertices, "the colour of the last vertex");
  if (in.integer("the table of regions") != 1) in.refuse("the annotation has no table of regions");
  const std::map<std::int32_t, std::int32_t> region = read_color_table(in);
  std::vector<double> numbers(vertices, -1);
  for (std::size_t i = 0; i < pairs.size(); i += 2) {
    if (!(pairs[i] >= 0 && pairs[i] < double(vertices))) {
      in.refuse(fmt::format("the annotation has a colour for vertex {}, and there are {}", pairs[i], vertices));
    }
    const auto found = region.find(std::int32_t(pairs[i + 1]));
    numbers[std::size_t(pairs[i])] = found == region.end() ? -1 : found->second;
  }
  return numbers;
}

}  // namespace gvd
