#include <fmt/format.h>

#include "gvd/text.hpp"
#include "io/generators/list_fields.hpp"
#include "io/generators/read_list_file.hpp"

namespace gvd {

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
