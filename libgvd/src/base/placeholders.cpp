// Placeholders in texts, as the header describes them.

#include "gvd/placeholders.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace gvd {
namespace {

constexpr std::string_view kOption = "{option:", kGiven = "{given:";

std::string spell_one(std::string_view inside, const OptionSpelling& spelling) {
  const std::size_t equals = inside.find('=');
  return spelling.spell(inside.substr(0, equals), equals == inside.npos ? "" : inside.substr(equals + 1));
}

/// Joined by "or".
std::string spell_given(std::string_view inside, const OptionSpelling& spelling) {
  std::vector<std::string_view> all, given;
  for (std::size_t begin = 0; begin <= inside.size();) {
    const std::size_t end = std::min(inside.find('|', begin), inside.size());
    all.push_back(inside.substr(begin, end - begin));
    begin = end + 1;
  }
  for (const std::string_view one : all) {
    if (spelling.is_given(one.substr(0, one.find('=')))) given.push_back(one);
  }
  std::string spelled;
  for (const std::string_view one : given.empty() ? all : given) {
    spelled += (spelled.empty() ? "" : " or ") + spell_one(one, spelling);
  }
  return spelled;
}

}  // namespace

std::string spell_options(std::string_view text, const OptionSpelling& spelling) {
  std::string spelled;
  for (std::size_t at = 0; at < text.size();) {
    const std::string_view rest = text.substr(at);
    const bool is_option = rest.starts_with(kOption), is_given = rest.starts_with(kGiven);
    const std::size_t end = is_option || is_given ? rest.find('}') : rest.npos;
    if (end == rest.npos) {
      spelled += text[at++];
      continue;
    }
    const std::size_t begin = (is_option ? kOption : kGiven).size();
    const std::string_view inside = rest.substr(begin, end - begin);
    spelled += is_option ? spell_one(inside, spelling) : spell_given(inside, spelling);
    at += end + 1;
  }
  return spelled;
}

std::string spell_options(std::string_view text) {
  return spell_options(text, {.spell = [](std::string_view name, std::string_view value) {
                         return value.empty() ? std::string(name) : std::string(name) + '=' + std::string(value);
                       }});
}

}  // namespace gvd
