// Placeholders in texts, as the header describes them.

#include "gvd/placeholders.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace gvd {
namespace {

constexpr char kMarkBegin = '\1', kMarkEnd = '\2', kIfGiven = '?';

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

std::string placeholder(std::string_view name, std::string_view value) {
  std::string text = kMarkBegin + std::string(name);
  if (!value.empty()) text += '=' + std::string(value);
  return text + kMarkEnd;
}

bool has_placeholder_mark(std::string_view text) {
  return text.find(kMarkBegin) != text.npos || text.find(kMarkEnd) != text.npos;
}

std::string spell_options(std::string_view text, const OptionSpelling& spelling) {
  std::string spelled;
  while (!text.empty()) {
    const std::size_t begin = text.find(kMarkBegin), end = text.find(kMarkEnd, std::min(begin, text.size()));
    spelled += text.substr(0, begin);
    if (begin == text.npos) break;
    if (end == text.npos) return spelled += text.substr(begin + 1);
    const std::string_view inside = text.substr(begin + 1, end - begin - 1);
    spelled += inside.starts_with(kIfGiven) ? spell_given(inside.substr(1), spelling) : spell_one(inside, spelling);
    text.remove_prefix(end + 1);
  }
  return spelled;
}

std::string spell_options(std::string_view text) {
  return spell_options(text, {.spell = [](std::string_view name, std::string_view value) {
                         return value.empty() ? std::string(name) : std::string(name) + '=' + std::string(value);
                       }});
}

std::string_view first_option(std::string_view text) {
  return text.starts_with(kMarkBegin) ? text.substr(1, text.find_first_of("=\2") - 1) : std::string_view();
}

}  // namespace gvd
