// Lists of generators as files: the format of a list, reading and writing it; and plain lists of numbers.
//
// The extension of a file picks its format, else its content does: JSON begins with a brace or bracket, and CSV has a
// comma in its first line, or the header `vertex`.
// Text keeps face and coordinates alone; the other formats write the position beside them, for other programs to read.
// Invariant: a written list reads back bit by bit, in any locale. fmt writes a double with the fewest digits that read
// back to the same bits.
#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

#include "gvd/error.hpp"
#include "gvd/generator_list.hpp"
#include "gvd/text.hpp"
#include "io/parse_lists.hpp"
#include "io/writers/format_writers.hpp"

namespace gvd {
namespace {

/// The content of a file that holds a list. `what` names its elements for messages: "generators".
std::string read_list_file(const std::filesystem::path& path, std::string_view what) {
  const auto refuse = [&](std::string_view message) {
    throw Error(ErrorCode::unreadable_input, fmt::format("{}: {}", path.string(), message));
  };
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) refuse(fmt::format("is a directory; name a list of {}", what));
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) refuse(fmt::format("{}; name a list of {}", std::strerror(errno), what));
  std::string content = read_to_end(file);
  if (file.bad()) refuse("could not be read to its end");
  return content;
}

std::optional<GeneratorFormat> format_of_extension(const std::filesystem::path& path) {
  const std::string extension = io::bare_extension(path.extension().string());
  if (extension == "json") return GeneratorFormat::json;
  if (extension == "csv") return GeneratorFormat::csv;
  return extension == "txt" ? std::optional(GeneratorFormat::text) : std::nullopt;
}

std::string text_of(const std::vector<SurfacePoint>& points) {
  std::string out = "# generators: face b0 b1 b2\n";
  for (const auto& [face, bary] : points) {
    fmt::format_to(std::back_inserter(out), "{} {}\n", face.value(), fmt::join(bary, " "));
  }
  return out;
}

std::string csv_of(const Mesh& mesh, const std::vector<SurfacePoint>& points) {
  std::string out = "face,b0,b1,b2,x,y,z\n";
  for (const SurfacePoint& point : points) {
    const Vec3 p = position(mesh, point);
    fmt::format_to(std::back_inserter(out), "{},{},{}\n", point.face.value(), fmt::join(point.bary, ","),
                   fmt::join(p.data(), p.data() + 3, ","));
  }
  return out;
}

std::string json_of(const Mesh& mesh, const std::vector<SurfacePoint>& points) {
  std::string out = "{\"schema\":\"gvd-generators/1\",\"generators\":[";
  const char* separator = "\n";
  for (const SurfacePoint& point : points) {
    const Vec3 p = position(mesh, point);
    fmt::format_to(std::back_inserter(out), "{}{{\"face\":{},\"bary\":[{}],\"position\":[{}]}}", separator,
                   point.face.value(), fmt::join(point.bary, ","), fmt::join(p.data(), p.data() + 3, ","));
    separator = ",\n";
  }
  return out + "\n]}\n";
}

}  // namespace

GeneratorFormat detect_generator_format(std::string_view content) {
  const std::vector<detail::ListLine> lines = detail::split_lines(content);
  const std::string_view first = lines.empty() ? std::string_view() : lines.front().text;
  if (first.starts_with('{') || first.starts_with('[')) return GeneratorFormat::json;
  const bool csv = first.find(',') != first.npos || first == "vertex" || first == "\"vertex\"";
  return csv ? GeneratorFormat::csv : GeneratorFormat::text;
}

GeneratorList parse_generators(std::string_view content, GeneratorFormat format, const std::string& name) {
  const auto parse = format == GeneratorFormat::json  ? detail::parse_json
                     : format == GeneratorFormat::csv ? detail::parse_csv
                                                      : detail::parse_text;
  GeneratorList list{name, parse(content, name)};
  if (list.entries.empty())
    throw Error(ErrorCode::unreadable_input, name + ":1: the list holds no generator; write at least one");
  return list;
}

GeneratorList read_generators(const std::filesystem::path& path, std::optional<GeneratorFormat> format) {
  const std::string content = read_list_file(path, "generators");
  if (!format) format = format_of_extension(path);
  return parse_generators(content, format ? *format : detect_generator_format(content), path.string());
}

std::string format_generators(const Mesh& mesh, const std::vector<SurfacePoint>& points, GeneratorFormat format) {
  if (format == GeneratorFormat::text) return text_of(points);
  return format == GeneratorFormat::csv ? csv_of(mesh, points) : json_of(mesh, points);
}

std::vector<double> parse_numbers(std::string_view content, const std::string& name) {
  std::vector<double> numbers;
  for (const auto& [text, line] : detail::split_lines(content)) {
    for (const std::string_view field : detail::split_fields(text, ',')) {
      const auto number = parse_number<double>(field);
      if (!number) detail::ListLocation{name, line}.refuse(fmt::format("{} is no number", quoted(field)));
      numbers.push_back(*number);
    }
  }
  return numbers;
}

std::vector<double> read_numbers(const std::filesystem::path& path) {
  return parse_numbers(read_list_file(path, "numbers"), path.string());
}

}  // namespace gvd
