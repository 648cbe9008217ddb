#include "common/options/option_text.hpp"

#include <algorithm>

namespace gvd::app {

std::string printable(std::string text, std::size_t longest) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return (c >= 0 && c < ' ') || c == 127; }, ' ');
  if (text.size() <= longest) return text;
  std::size_t end = longest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;  // no half character of UTF-8
  return text.substr(0, end) + "...";
}

std::vector<std::string> split_names(const std::string& names) {
  std::vector<std::string> split;
  for (std::size_t start = 0; start <= names.size();) {
    const std::size_t comma = std::min(names.find(',', start), names.size());
    split.push_back(names.substr(start, comma - start));
    start = comma + 1;
  }
  return split;
}

bool is_given_as(const GivenOption& given, const std::string& wanted) {
  const std::size_t blank = wanted.find(' ');
  const std::vector<std::string> names = split_names(given.option->text.names);
  if (std::find(names.begin(), names.end(), wanted.substr(0, blank)) == names.end()) return false;
  const auto has = [&given](const std::string& value) {
    return std::find(given.values.begin(), given.values.end(), value) != given.values.end();
  };
  if (given.option->text.kind == ValueKind::flag) return !has("false");
  return blank == wanted.npos || has(wanted.substr(blank + 1));
}

}  // namespace gvd::app
