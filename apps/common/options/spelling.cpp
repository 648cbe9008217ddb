// Spells names of options as on a command line and in a file. Descriptions have underscores, but users type dashes.

#include "common/options/spelling.hpp"

#include <algorithm>
#include <string_view>
#include <variant>

#include "gvd/error.hpp"
#include "gvd/option_text.hpp"
#include "gvd/text.hpp"

namespace gvd::app {

std::string dashed_name(const Option& option) {
  std::string name = option.is_on ? "no-" + option.name : option.name;
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

std::vector<std::string> typed_names(const Option& option) {
  std::string name = dashed_name(option);
  if (option.spec.positional) {
    std::transform(name.begin(), name.end(), name.begin(), [](char c) { return static_cast<char>(c - 'a' + 'A'); });
    return {name};
  }
  std::vector<std::string> names;
  if (!option.spec.short_name.empty()) names.push_back("-" + option.spec.short_name);
  if (name != option.spec.short_name) names.push_back("--" + name);
  return names;
}

std::string usual_name(const Option& option) { return typed_names(option).front(); }

std::vector<std::string> file_keys(const Option& option) {
  if (option.spec.shown == Shown::answered || option.spec.shown == Shown::hidden) return {};
  std::vector<std::string> keys;
  if (!option.spec.short_name.empty()) keys.push_back(option.spec.short_name);
  keys.push_back(dashed_name(option));
  return keys;
}

std::string spell(const OptionList& list, const Given& given, const std::string& text, bool in_file) {
  const auto spell_one = [&](std::string_view name, std::string_view value) {
    const Option* const option = list.find(name);
    if (option == nullptr) {  // not in the list: spelled as for any command
      std::string typed = "--" + std::string(name);
      std::replace(typed.begin(), typed.end(), '_', '-');
      return value.empty() ? typed : typed + ' ' + std::string(value);
    }
    const Given::Source* const source = given.find(name);
    const bool as_key = source != nullptr ? !source->place.empty() : in_file;
    std::string spelled = source != nullptr ? source->spelling : as_key ? dashed_name(*option) : usual_name(*option);
    const bool is_flag = std::holds_alternative<Flag>(option->field);
    if (value.empty() || (is_flag && !as_key)) return spelled;
    if (is_flag) return spelled + " = true";
    const std::string shown(value);
    if (!as_key) return spelled + ' ' + shown;
    return spelled + " = " + (parse_number<double>(value) ? shown : '"' + shown + '"');
  };
  return spell_options(text, {spell_one, [&](std::string_view name) { return given.has(name); }});
}

std::string spell(const OptionList& list, const std::string& text) { return spell(list, Given(), text); }

void refuse_option(const OptionList& list, const Given& given, const Problem& problem, const std::string& hint) {
  const Given::Source* const source = given.find(problem.option);
  const bool in_file = source != nullptr && !source->place.empty();
  const std::string text = spell(list, given, problem.text, in_file);
  throw Error(ErrorCode::invalid_option, in_file ? source->place + ": " + text : text + hint);
}

}  // namespace gvd::app
