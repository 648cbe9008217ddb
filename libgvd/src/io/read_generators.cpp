// Lists of generators as files: the format of a list, reading and writing it; and plain lists of numbers.
//
// The extension of a file picks its format, else its content does: JSON begins with a brace or bracket, and CSV has a
// comma in its first line, or the header `vertex`.
// Invariant: a written list reads back bit by bit, in any locale. fmt writes a double with the fewest digits that read
// back to the same bits.
#include <fmt/format.h>

#include <iterator>

#include "gvd/error.hpp"
#include "gvd/generator_list.hpp"
#include "gvd/text.hpp"
#include "io/parse_lists.hpp"

namespace gvd {
namespace {

std::optional<GeneratorFormat> format_of_extension(const std::filesystem::path& path) {
  const std::string extension = to_lower(path.extension().string());
  if (extension == ".json") return GeneratorFormat::json;
  if (extension == ".csv") return GeneratorFormat::csv;
  return extension == ".txt" ? std::optional(GeneratorFormat::text) : std::nullopt;
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
  GeneratorList list{name, {}};
  switch (format) {
    case GeneratorFormat::text:
      list.entries = detail::parse_text(content, name);
      break;
    case GeneratorFormat::csv:
      list.entries = detail::parse_csv(content, name);
      break;
    case GeneratorFormat::json:
      list.entries = detail::parse_json(content, name);
      break;
  }
  if (list.entries.empty())
    throw Error(ErrorCode::unreadable_input, name + ":1: the list holds no generator; write at least one");
  return list;
}

GeneratorList read_generators(const std::filesystem::path& path, std::optional<GeneratorFormat> format) {
  const std::string content = detail::read_list_file(path, "generators");
  if (!format) format = format_of_extension(path);
  return parse_generators(content, format ? *format : detect_generator_format(content), path.string());
}

std::string format_generators(const Mesh& mesh, const std::vector<SurfacePoint>& points, GeneratorFormat format) {
  switch (format) {
    case GeneratorFormat::csv:
      return csv_of(mesh, points);
    case GeneratorFormat::json:
      return json_of(mesh, points);
    case GeneratorFormat::text:
      break;
  }
  return text_of(points);
}

std::vector<double> parse_numbers(std::string_view content, const std::string& name) {
  std::vector<double> numbers;
  for (const auto& [text, line] : detail::split_lines(content)) {
    for (const std::string_view field : detail::split_fields(text, ',')) {
      const auto number = detail::parse_field<double>(field);
      if (!number) detail::ListLocation{name, line}.refuse(fmt::format("{} is no number", quoted(field)));
      numbers.push_back(*number);
    }
  }
  return numbers;
}

std::vector<double> read_numbers(const std::filesystem::path& path) {
  return parse_numbers(detail::read_list_file(path, "numbers"), path.string());
}

}  // namespace gvd
