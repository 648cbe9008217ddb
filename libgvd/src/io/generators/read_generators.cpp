#include "gvd/error.hpp"
#include "gvd/generator_list.hpp"
#include "io/generators/list_fields.hpp"
#include "io/generators/parse_csv.hpp"
#include "io/generators/parse_json.hpp"
#include "io/generators/parse_text.hpp"
#include "io/generators/read_list_file.hpp"

namespace gvd {
namespace {

std::optional<GeneratorFormat> format_of_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  if (extension == ".json") return GeneratorFormat::json;
  if (extension == ".csv") return GeneratorFormat::csv;
  return extension == ".txt" ? std::optional(GeneratorFormat::text) : std::nullopt;
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

}  // namespace gvd
