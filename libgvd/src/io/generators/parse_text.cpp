#include "io/generators/parse_text.hpp"

#include "io/generators/list_fields.hpp"

namespace gvd::detail {

std::vector<GeneratorEntry> parse_text(std::string_view content, const std::string& name) {
  std::vector<GeneratorEntry> entries;
  for (const auto& [text, number] : split_lines(content)) {
    entries.push_back(parse_entry(split_blanks(text), {name, number}));
  }
  return entries;
}

}  // namespace gvd::detail
