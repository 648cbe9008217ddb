// Writes placeholders, and replaces them by the names of options as a reader spells them. gvd/placeholders.hpp has the
// syntax.

#include "gvd/placeholders.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace gvd {
namespace {

constexpr char kMarkBegin = '\1', kMarkEnd = '\2', kIfGiven = '?', kAdvice = '+';

std::string spell_one(std::string_view inside, const OptionSpelling& spelling) {
  const std::size_t equals = inside.find('=');
  return spelling.spell(inside.substr(0, equals), equals == inside.npos ? "" : inside.substr(equals + 1));
}

/// Spells the options that the user gave, or all of them if none was given, joined by "or".
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

/// Spells advice: words and, behind a bar, the option that they advise. Empty if the reader can't give that option.
std::string spell_advice(std::string_view inside, const OptionSpelling& spelling) {
  const std::size_t bar = inside.find('|');
  const std::string_view option = inside.substr(bar + 1);
  if (!spelling.can_give(option.substr(0, option.find('=')))) return "";
  return std::string(inside.substr(0, bar)) + spell_one(option, spelling);
}

std::string spell_inside(std::string_view inside, const OptionSpelling& spelling) {
  if (inside.starts_with(kIfGiven)) return spell_given(inside.substr(1), spelling);
  if (inside.starts_with(kAdvice)) return spell_advice(inside.substr(1), spelling);
  return spell_one(inside, spelling);
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
    spelled += spell_inside(text.substr(begin + 1, end - begin - 1), spelling);
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
