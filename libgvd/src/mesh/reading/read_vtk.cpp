// Reads legacy files of VTK (.vtk), text and binary: PolyData, and the surface cells of unstructured grids.
//
// Keywords and counts are text; numbers are text or big-endian. Cells are lists that begin with their length or, since
// version 5.1, two arrays. The sections after the cells hold data of points and cells, and are not read.
// Source: VTK File Formats, version 4.2, and the release notes of VTK 9 for version 5.1 of the format.
// Invariant: each count is compared with the number of remaining bytes before memory is allocated for it.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "gvd/error.hpp"
#include "gvd/text.hpp"
#include "mesh/reading/readers.hpp"
#include "mesh/reading/vtk_soup.hpp"

namespace gvd {
namespace {

constexpr std::string_view kWhitespace = " \t\r\n\v\f";

/// First version whose cells are arrays of offsets and corners.
constexpr double kOffsetsVersion = 5;

class VtkParser {
 public:
  VtkParser(std::string_view bytes, std::string_view name) : bytes_(bytes), name_(name), soup_(name) {}

  PolygonSoup parse() {
    read_header();
    for (std::string word = keyword(); !word.empty() && !is_data_section(word); word = keyword()) read_section(word);
    // Sections of data are not parsed, only searched for: each begins a line.
    if (bytes_.find("\nTEXTURE_COORDINATES ", at_) != bytes_.npos) soup_.leave_out_texture();
    if (!cells_.ends.empty()) soup_.add_cells(cells_, cell_types_);
    return soup_.take();
  }

 private:
  void read_header() {
    const std::string_view mark = line();
    const auto version = parse_double(mark.substr(mark.find_last_of(" \t") + 1));
    if (!version) refuse("the first line names no version, as in '# vtk DataFile Version 3.0'");
    has_offsets_ = *version >= kOffsetsVersion;
    line();  // skips the title
    const std::string encoding = keyword();
    if (encoding != "ascii" && encoding != "binary") {
      refuse(fmt::format("the third line is {}, and should be ASCII or BINARY", gvd::quoted(encoding)));
    }
    is_binary_ = encoding == "binary";
  }

  static bool is_data_section(std::string_view word) { return word == "point_data" || word == "cell_data"; }

  void read_section(const std::string& word) {
    if (word == "dataset") {
      const std::string kind = keyword();
      if (kind != "polydata" && kind != "unstructured_grid") {
        refuse(fmt::format("the data set is {}, and should be POLYDATA or UNSTRUCTURED_GRID; extract the surface first",
                           gvd::quoted(kind)));
      }
    } else if (word == "points") {
      const std::uint64_t points = count();
      soup_.add_points(numbers(3 * points, type()));
    } else if (word == "polygons") {
      soup_.add_polygons(cells());
    } else if (word == "triangle_strips") {
      soup_.add_strips(cells());
    } else if (word == "vertices" || word == "lines") {
      soup_.leave_out(cells());
    } else if (word == "cells") {
      cells_ = cells();
    } else if (word == "cell_types") {
      const std::uint64_t types = count();
      cell_types_ = numbers(types, plain_int());
    } else if (word == "field") {
      skip_field();
    } else if (word == "metadata") {
      for (line(); at_ < bytes_.size() && line().find_first_not_of(kWhitespace) != std::string_view::npos;) continue;
    } else {
      refuse(fmt::format("{} is not a section of a surface", gvd::quoted(word)));
    }
  }

  VtkCells cells() {
    const std::uint64_t lists = count(), size = count();
    VtkCells cells;
    if (has_offsets_) {
      if (lists == 0) return cells;
      cells.ends = numbers(lists, offsets_type("offsets"));
      cells.corners = numbers(size, offsets_type("connectivity"));
      if (cells.ends.front() != 0) refuse(fmt::format("the offsets begin with {} and not with 0", cells.ends.front()));
      cells.ends.erase(cells.ends.begin());
      return cells;
    }
    const std::vector<double> mixed = numbers(size, plain_int());
    for (std::size_t i = 0; i < mixed.size();) {
      const double length = mixed[i++];
      if (!(length >= 0 && length <= double(mixed.size() - i))) {
        refuse(fmt::format("cell {} should have {} {}, but {}; {}", cells.ends.size(), length,
                           length == 1 ? "corner" : "corners",
                           counted(std::int64_t(mixed.size() - i), "number follows", "numbers follow"), kExportAgain));
      }
      cells.corners.insert(cells.corners.end(), mixed.begin() + std::ptrdiff_t(i),
                           mixed.begin() + std::ptrdiff_t(i + std::size_t(length)));
      cells.ends.push_back(double(cells.corners.size()));
      i += std::size_t(length);
    }
    if (cells.ends.size() != lists) {
      refuse(fmt::format("the list has {}, and should have {}; {}", counted(std::ssize(cells.ends), "cell", "cells"),
                         lists, kExportAgain));
    }
    return cells;
  }

  StoredNumber offsets_type(std::string_view wanted) {
    const std::string word = keyword();
    if (word != wanted) refuse(fmt::format("expected {}, found {}", gvd::quoted(wanted), gvd::quoted(word)));
    return type();
  }

  void skip_field() {
    keyword();  // skips the name
    for (std::uint64_t arrays = count(); arrays > 0; --arrays) {
      const std::string name = keyword();
      if (name == "metadata") {
        read_section(name);
        ++arrays;
        continue;
      }
      const std::uint64_t components = count(), tuples = count();
      if (components != 0 && tuples > bytes_.size() / components) refuse_count(tuples);
      numbers(components * tuples, type());
    }
  }

  std::string_view line() {
    const std::size_t end = std::min(bytes_.find('\n', at_), bytes_.size());
    const std::string_view text = bytes_.substr(at_, end - at_);
    at_ = std::min(end + 1, bytes_.size());
    return text.ends_with('\r') ? text.substr(0, text.size() - 1) : text;
  }

  std::string_view token() {
    at_ = std::min(bytes_.find_first_not_of(kWhitespace, at_), bytes_.size());
    const std::size_t end = std::min(bytes_.find_first_of(kWhitespace, at_), bytes_.size());
    const std::size_t begin = std::exchange(at_, end);
    return bytes_.substr(begin, end - begin);
  }

  std::string keyword() { return to_lower(token()); }

  std::uint64_t count() {
    const std::string_view text = token();
    const auto value = parse_number<std::uint64_t>(text);
    if (!value) refuse(fmt::format("expected a count, found {}", quoted(text)));
    if (*value > bytes_.size()) refuse_count(*value);
    return *value;
  }

  StoredNumber type() {
    const std::string_view word = token();
    auto found = find_vtk_type(word);
    if (!found) refuse(fmt::format("{} is not a type of numbers that is read", quoted(word)));
    found->big_endian = true;
    end_keywords();
    return *found;
  }

  /// The type of numbers in a section that names no type.
  StoredNumber plain_int() {
    end_keywords();
    return {StoredNumber::Kind::signed_integer, 4, true};
  }

  /// Moves to the numbers: binary ones begin on the line after the keywords.
  void end_keywords() {
    if (is_binary_) line();
  }

  std::vector<double> numbers(std::uint64_t wanted, const StoredNumber& stored) {
    const std::uint64_t left = bytes_.size() - at_;
    // As text, a number takes a digit and a blank.
    if (wanted > (is_binary_ ? left / stored.size : (left + 1) / 2)) refuse_count(wanted);
    if (is_binary_) {
      const std::string_view data = bytes_.substr(at_, wanted * stored.size);
      at_ += data.size();
      return stored.read_all(data);
    }
    std::vector<double> values(wanted);
    for (double& value : values) {
      const std::string_view text = token();
      const auto number = parse_double(text);
      if (!number) refuse(fmt::format("expected a number, found {}", quoted(text)));
      value = *number;
    }
    return values;
  }

  [[noreturn]] void refuse_count(std::uint64_t wanted) const {
    refuse(fmt::format("{} promised, and the file has {}", counted(std::int64_t(wanted), "number is", "numbers are"),
                       counted(std::int64_t(bytes_.size() - at_), "more byte", "more bytes")));
  }

  /// Throws with the line or, in a binary file, with the byte.
  [[noreturn]] void refuse(const std::string& message) const {
    const auto lines = std::ranges::count(bytes_.substr(0, at_), '\n') + 1;
    throw Error(ErrorCode::unreadable_input, is_binary_ ? fmt::format("{}: byte {}: {}", name_, at_, message)
                                                        : fmt::format("{}:{}: {}", name_, lines, message));
  }

  std::string_view bytes_;
  std::string name_;
  VtkSoup soup_;
  std::size_t at_ = 0;
  bool is_binary_ = false, has_offsets_ = false;
  VtkCells cells_;  // of an unstructured grid
  std::vector<double> cell_types_;
};

}  // namespace

PolygonSoup parse_vtk(std::string_view bytes, std::string_view name) { return VtkParser(bytes, name).parse(); }

}  // namespace gvd
