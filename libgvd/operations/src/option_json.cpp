// Writes options as JSON: their values, and the kinds of values that they take.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "given_arrays.hpp"
#include "gvd/curve_list.hpp"
#include "gvd/generator_list.hpp"
#include "gvd/operation_json.hpp"
#include "gvd/option_text.hpp"
#include "gvd/read_values.hpp"

namespace gvd {
namespace {

using Json = nlohmann::ordered_json;

template <class T>
Json or_null(const T& value) {
  return value;
}
template <class T>
Json or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json();
}
Json or_null(const std::string& text) { return text.empty() ? Json() : Json(text); }

Json value_of(const Field& field) {
  return std::visit(
      Overload{
          [](const Flag& flag) { return Json(*flag.value == flag.given_as); },
          [](const Switch& on_off) { return or_null(*on_off.value); },
          [](const Number& number) {
            const Json value = std::visit([](const auto* v) { return or_null(*v); }, number.value);
            const auto word = value.is_null() ? std::string_view() : name_in(number.words, value.get<double>());
            return word.empty() ? value : Json(word);
          },
          [](const Choice& choice) {
            const auto place = choice.get();
            return place ? Json(choice.names[*place]) : Json();
          },
          [](const ChoiceList& list) { return Json(*list.value); },
          [](const File& file) { return std::visit([](const auto* names) { return or_null(*names); }, file.value); },
          [](const PointList& list) {
            return list.value->vertices ? Json(*list.value->vertices) : or_null(list.value->file);
          },
          [](const Curves& curves) { return or_null(curves.value->name); },
          [](const Counts& counts) { return counts.value->empty() ? Json() : Json(*counts.value); },
          [](const ValueSource& values) { return or_null(values.value->name); },
          [](const ByteSize& size) { return or_null(*size.value); },
          [](const SizeOrPercent& size) {
            if (!*size.value) return Json();
            const ErrorBound& bound = **size.value;
            return bound.in_diagonals ? Json(fmt::format("{:.15g}%", bound.value * 100)) : Json(bound.value);
          },
          [](const CreaseAngle& angle) {
            return *angle.automatic ? Json("auto") : *angle.value ? Json(**angle.value) : Json("none");
          }},
      field);
}

Json describe_number(const Number& number) {
  Json kind{{"kind", is_real(number) ? "number" : "whole number"}, {"range", describe_range(number)}};
  const Range& range = number.range;
  if (std::isfinite(range.least)) kind[range.above_least ? "above" : "least"] = range.least;
  if (std::isfinite(range.most)) kind[range.below_most ? "below" : "most"] = range.most;
  if (!number.words.empty()) kind["choices"] = names_in(number.words);
  return kind;
}

/// Describes a kind of options, and the values that it takes.
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
               [&](const PointList& list) {
                 using Named = PointList::Named;
                 return named(list.named == Named::vertices ? "vertices"
                              : list.named == Named::file   ? "input file"
                                                            : "points");
               },
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

/// The value that an option stands for; null if other options make it ineffective.
Json used_value(const OptionList& list, const Given& given, const Option& option) {
  const Given::Source* const source = given.find(option.name);
  if (source != nullptr && !source->value.empty()) return Json::parse(source->value);
  Json value = value_of(option.field);
  if (!takes_value(option.field) || (value.is_array() && value.empty())) return value;
  const auto excludes_it = [&](const Option* other) {
    return given.has(other->name) && list.exclude_each_other(option.name, other->name);
  };
  const bool is_idle = source == nullptr && std::ranges::any_of(list.options(), excludes_it);
  return is_idle || !list.why_idle(option, given).empty() ? Json() : value;
}

}  // namespace

std::string value_json(const Field& field) {
  return value_of(field).dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string kind_json(const Field& field) { return describe_kind(field).dump(); }

std::string options_json(const OptionList& list, const Given& given, Door door) {
  Json values = Json::object();
  for (const Option* const option : list.options()) {
    const bool is_question = option->spec.shown == Shown::answered || option->spec.shown == Shown::hidden;
    if (is_question) continue;
    Json& value = values[option->name] = used_value(list, given, *option);
    const bool is_rounded = door == Door::javascript && value.is_number_integer() && value.get<double>() >= kMostWhole;
    if (is_rounded) value = value.dump();
  }
  return values.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace gvd
