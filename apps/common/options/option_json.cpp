// Writes options as JSON, with their values for reports and with descriptions for other programs that show options; and
// the table of formats.

#include "common/options/option_json.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "common/options/help.hpp"
#include "common/options/spelling.hpp"
#include "gvd/operation_json.hpp"
#include "gvd/option_text.hpp"

namespace gvd::app {
namespace {

using Json = nlohmann::ordered_json;

Json text_or_null(const std::string& text) { return text.empty() ? Json() : Json(text); }

bool is_question(const Option& option) {
  return option.spec.shown == Shown::answered || option.spec.shown == Shown::hidden;
}

}  // namespace

Json describe_options(const OptionList& list) {
  Json all = Json::array();
  for (const Option* const option : list.options()) {
    if (is_question(*option)) continue;
    Json& one = all.emplace_back(Json{{"name", option->name}, {"names", typed_names(*option)}});
    one["group"] = spell(list, option->group);
    one.update(Json::parse(kind_json(option->field)));
    one["value"] = value_name(option->field);
    one["repeatable"] = takes_value(option->field) && is_repeatable(option->field);
    one["unit"] = text_or_null(option->spec.unit);
    one["default"] = text_or_null(spell(list, option->spec.usual));
    one["summary"] = spell(list, option->spec.help);
    one["help"] = describe_in_full(list, *option);
    one["main"] = option->spec.shown == Shown::main;
    Json& excluded = one["excludes"] = Json::array();
    for (const Option* const other : list.options()) {
      if (list.exclude_each_other(option->name, other->name)) excluded.push_back(other->name);
    }
    one["needs"] = list.needed_by(option->name);
  }
  return all;
}

std::string print_description(const OptionList& list) {
  const std::vector<std::string> unknown = list.find_unknown_names();
  if (!unknown.empty()) {
    throw std::logic_error(fmt::format("rules or texts name the unknown option {}", fmt::join(unknown, " or ")));
  }
  return Json{{"options", describe_options(list)}, {"formats", Json::parse(formats_json())}}.dump(1) + "\n";
}

}  // namespace gvd::app
