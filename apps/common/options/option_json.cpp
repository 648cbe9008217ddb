// Options as JSON: their values for reports, and their description for whatever else shows options; and the formats.

#include "common/options/option_json.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "common/options/help.hpp"
#include "common/options/spelling.hpp"
#include "gvd/io/format.hpp"
#include "gvd/option_text.hpp"

namespace gvd::app {
namespace {

using Json = nlohmann::ordered_json;

template <class T>
Json or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json();
}
Json or_null(const std::string& text) { return text.empty() ? Json() : Json(text); }

Json value_of(const Field& field) {
  const auto plain = [](const auto* value) { return Json(*value); };
  return std::visit(
      Overload{[](const Flag& flag) { return Json(*flag.value == flag.given_as); },
               [](const Switch& on_off) { return or_null(*on_off.value); },
               [&](const Number& number) {
                 return std::visit(Overload{plain, [](const std::optional<std::int32_t>* v) { return or_null(*v); },
                                            [](const std::optional<std::int64_t>* v) { return or_null(*v); },
                                            [](const std::optional<double>* v) { return or_null(*v); }},
                                   number.value);
               },
               [](const Choice& choice) {
                 const auto place = choice.get();
                 return place ? Json(choice.names[*place]) : Json();
               },
               [](const ChoiceList& list) { return Json(*list.value); },
               [](const File& file) {
                 return std::visit(Overload{[](const std::string* name) { return or_null(*name); },
                                            [](const std::vector<std::string>* names) { return Json(*names); }},
                                   file.value);
               },
               [](const PointList& list) {
                 if (list.file != nullptr && !list.file->empty()) return Json(*list.file);
                 return or_null(*list.vertices);
               },
               [](const Curves& curves) { return or_null(*curves.value); },
               [](const Counts& counts) { return counts.value->empty() ? Json() : Json(*counts.value); },
               [](const ValueSource& values) { return or_null(*values.value); },
               [](const ByteSize& size) { return or_null(*size.value); },
               [](const SizeOrPercent& size) {
                 if (!*size.value) return Json();
                 const ErrorBound& bound = **size.value;
                 return bound.in_diagonals ? Json(fmt::format("{:.15g}%", bound.value * 100)) : Json(bound.value);
               },
               [](const CreaseAngle& angle) { return *angle.automatic ? Json("auto") : or_null(*angle.value); }},
      field);
}

bool is_question(const Option& option) {
  return option.spec.shown == Shown::answered || option.spec.shown == Shown::hidden;
}

Json describe_number(const Number& number) {
  Json kind{{"kind", is_real(number) ? "number" : "whole number"}, {"range", describe_range(number)}};
  const Range& range = number.range;
  if (std::isfinite(range.least)) kind[range.above_least ? "above" : "least"] = range.least;
  if (std::isfinite(range.most)) kind[range.below_most ? "below" : "most"] = range.most;
  if (!number.words.empty()) kind["choices"] = names_in(number.words);
  return kind;
}

/// The name of a kind, and what it takes.
Json describe_kind(const Field& field) {
  const auto named = [](const char* kind) { return Json{{"kind", kind}}; };
  return std::visit(
      Overload{[&](const Flag&) { return named("flag"); }, [&](const Switch&) { return named("switch"); },
               [](const Number& number) { return describe_number(number); },
               [](const Choice& choice) {
                 return Json{{"kind", "choice"}, {"choices", choice.names}};
               },
               [](const ChoiceList& list) {
                 return Json{{"kind", "choices"}, {"choices", list.names}};
               },
               [](const File& file) {
                 const bool is_folder = file.use == File::Use::folder;
                 Json kind{{"kind", is_folder ? "folder" : file.use == File::Use::read ? "input file" : "output file"}};
                 if (!file.extensions.empty()) kind["extensions"] = file.extensions;
                 return kind;
               },
               [&](const PointList& list) { return named(list.file == nullptr ? "vertices" : "points"); },
               [&](const Curves&) { return named("curves"); }, [&](const Counts&) { return named("counts"); },
               [](const ValueSource& values) {
                 Json kind{{"kind", "values"}};
                 if (!values.words.empty()) kind["choices"] = values.words;
                 return kind;
               },
               [&](const ByteSize&) { return named("bytes"); }, [&](const SizeOrPercent&) { return named("bound"); },
               [&](const CreaseAngle&) { return named("crease angle"); }},
      field);
}

}  // namespace

Json report_options(const OptionList& list, const Given& given) {
  Json values = Json::object();
  for (const Option* const option : list.options()) {
    if (is_question(*option)) continue;
    const bool is_flag = !takes_value(option->field);
    const bool is_used = is_flag || list.why_idle(*option, given).empty();
    values[option->name] = is_used ? value_of(option->field) : Json();
  }
  return values;
}

Json describe_options(const OptionList& list) {
  Json all = Json::array();
  for (const Option* const option : list.options()) {
    if (is_question(*option)) continue;
    Json& one = all.emplace_back(Json{{"name", option->name}, {"names", typed_names(*option)}});
    one["group"] = spell(list, option->group);
    one.update(describe_kind(option->field));
    one["value"] = value_name(option->field);
    one["repeatable"] = takes_value(option->field) && is_repeatable(option->field);
    one["unit"] = or_null(option->spec.unit);
    one["default"] = or_null(spell(list, option->spec.usual));
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

Json describe_formats() {
  Json all = Json::array();
  for (const Format& format : formats()) {
    Json& one = all.emplace_back(Json{{"name", format.name}, {"title", or_null(std::string(format.title))}});
    one["extensions"] = format.extensions;
    one["input_extensions"] = format.input_extensions;
    one["is_read"] = format.read != nullptr;
    one["is_written"] = format.is_output();
    one["is_binary"] = format.is_binary;
    Json& carries = one["carries"] = Json::array();
    for (const auto& [name, content] : kContentNames) {
      if (has_any(format.carries, content)) carries.push_back(name);
    }
  }
  return all;
}

std::string print_description(const OptionList& list) {
  const std::vector<std::string> unknown = list.find_unknown_names();
  if (!unknown.empty()) {
    throw std::logic_error(fmt::format("no option is called {}, as rules or texts do", fmt::join(unknown, " or ")));
  }
  return Json{{"options", describe_options(list)}, {"formats", describe_formats()}}.dump(1) + "\n";
}

}  // namespace gvd::app
