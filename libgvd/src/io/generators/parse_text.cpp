#include "io/generators/parse_text.hpp"

#include "io/generators/list_fields.hpp"

namespace gvd::detail {

std::vector<GeneratorEntry> parse_text(std::string_view content, const std::string& name) {
  std::vector<ListRow> rows;
  for (const auto& [text, number] : split_lines(content)) {
    if (text.find(',') != text.npos) {
      ListLocation{name, number}.refuse("has a comma; part the fields by blanks, or give the list as CSV");
    }
    rows.push_back({split_fields(text), number});
  }
  return parse_entries(rows, name, ' ');
}

}  // namespace gvd::detail
