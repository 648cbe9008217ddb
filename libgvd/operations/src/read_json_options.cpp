// Reads options from JSON.
//
// A scalar is read as its text, so that JSON and the command line accept and refuse the same values; arrays and lists
// are read by given_arrays.hpp. Every mistake is reported in one line that begins with the name of the option.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>
#include <vector>

#include "given_arrays.hpp"
#include "gvd/curve_list.hpp"
#include "gvd/error.hpp"
#include "gvd/operation_json.hpp"
#include "gvd/option_text.hpp"
#include "gvd/text.hpp"

namespace gvd {
namespace {

using Json = nlohmann::ordered_json;

[[noreturn]] void refuse_json(const std::string& text) { throw Error(ErrorCode::invalid_option, text); }

/// No option has deeply nested lists, and very deep ones would overflow the stack when they are printed or freed.
constexpr int kDeepest = 8;

/// Checks JSON while it is parsed. A name that occurs twice in an object would silently lose its first value.
class CheckedWhileRead {
 public:
  bool operator()(int depth, Json::parse_event_t event, const Json& parsed) {
    if (depth > kDeepest) refuse_json(fmt::format("options: lists and objects are nested more than {} deep", kDeepest));
    if (event == Json::parse_event_t::key && depth == 1 && !names_.insert(parsed.get<std::string>()).second) {
      refuse_json(fmt::format("\"{}\" is given twice; keep one", printable(parsed.get_ref<const std::string&>())));
    }
    return true;
  }

 private:
  std::set<std::string> names_;
};

std::string describe_place(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, byte == 0 ? 0 : byte - 1);
  const std::size_t line = std::size_t(std::count(before.begin(), before.end(), '\n')) + 1;
  const std::size_t start = before.rfind('\n');
  return fmt::format("line {}, column {}", line, before.size() - (start == before.npos ? 0 : start + 1) + 1);
}

Json parse(std::string_view text) {
  try {
    const Json parsed = Json::parse(text, CheckedWhileRead());
    if (!parsed.is_object()) refuse_json("options: the JSON is not an object; write one, such as {\"count\": 30}");
    return parsed;
  } catch (const Json::parse_error& error) {
    refuse_json(fmt::format("options: not valid JSON at {}", describe_place(text, error.byte)));
  } catch (const Json::out_of_range&) {
    refuse_json("options: the JSON has a number that is too large for a double");
  }
}

/// The text of a value on a command line; nothing for lists and objects. 3.0 counts as the whole number 3, because
/// languages differ in how they write it.
std::optional<std::string> to_text(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_float()) {
    const auto number = value.get<double>();
    if (std::abs(number) < kMostWhole && number == std::trunc(number)) return fmt::format("{:.0f}", number);
  }
  if (value.is_number() || value.is_boolean()) return value.dump();
  return std::nullopt;
}

/// The text of a value, or the texts of the elements of a list.
std::vector<std::string> to_texts(const Json& value) {
  std::vector<std::string> texts;
  if (value.is_array()) {
    for (const Json& one : value) texts.push_back(to_text(one).value_or(one.dump()));
  } else {
    texts.push_back(to_text(value).value_or(value.dump()));
  }
  return texts;
}

/// Reads curves from {"file": NAME}. If there is an array "content", it has the bytes of the file.
CurveList read_curve_file(const Json& value, const Arrays& arrays) {
  const Json& file = value.at("file");
  const bool is_text = file.is_string();
  if (!is_text && !is_array_reference(file)) refuse_json("\"file\": a name is needed");
  const std::string path = is_text ? file.get<std::string>() : read_bytes(file, arrays);
  if (value.size() == 1) return gvd::read_curves(path);
  const bool has_content = value.size() == 2 && value.contains("content") && is_array_reference(value["content"]);
  if (!has_content) refuse_json("only \"content\", an array of the file's bytes, may accompany \"file\"");
  return parse_curves(read_bytes(value["content"], arrays), path);
}

/// Reads one option. Each function returns what is wrong, or an empty text.
class OptionReader {
 public:
  OptionReader(const Option& option, const Json& value, const Arrays& arrays)
      : option_(option), value_(value), arrays_(arrays), name_(fmt::format("\1{}\2", option.name)) {}

  std::string operator()(const PointList& list) const {
    if (list.named == PointList::Named::vertices && !is_mesh_reference(value_)) {
      *list.value = {read_indices(value_, arrays_), {}, nullptr};
    } else {
      *list.value = {{}, {}, std::make_shared<GeneratorList>(read_points(value_, arrays_, name_))};
    }
    return "";
  }

  std::string operator()(const Curves& curves) const {
    if (value_.is_object() && value_.contains("file")) {
      *curves.value = {{}, std::make_shared<CurveList>(read_curve_file(value_, arrays_))};
      return "";
    }
    if (word() == "boundary" || word() == "creases" || word().starts_with("creases:")) return as_text();
    if (value_.is_string()) {
      return gvd::quoted(word()) + " is none of boundary, creases and creases:ANGLE; or give points";
    }
    *curves.value = {{}, std::make_shared<CurveList>(gvd::read_curves(value_, arrays_, name_))};
    return "";
  }

  std::string operator()(const ValueSource& values) const {
    if (std::find(values.words.begin(), values.words.end(), word()) != values.words.end()) return as_text();
    if (value_.is_string() && !values.words.empty()) {
      return fmt::format("{} (numbers serve, too)", describe_unknown(word(), values.words));
    }
    *values.value = {{}, std::make_shared<ElementValues>(read_numbers(value_, arrays_, values.of, name_))};
    return "";
  }

  std::string operator()(const Flag&) const { return value_.is_boolean() ? as_text() : no_flag(); }
  std::string operator()(const Switch&) const {
    return value_.is_boolean() || value_.is_string() ? as_text() : no_flag();
  }

  std::string operator()(const File&) const {  // as bytes, because a name need not be valid UTF-8, which JSON requires
    if (is_array_reference(value_)) return read_option(option_, {read_bytes(value_, arrays_)});
    const bool is_text =
        value_.is_string() ||
        (value_.is_array() && std::ranges::all_of(value_, [](const Json& one) { return one.is_string(); }));
    return is_text ? read_option(option_, to_texts(value_)) : gvd::quoted(value_.dump()) + " is not text";
  }

  std::string operator()(const Counts&) const {
    return read_option(option_, to_texts(is_array_reference(value_) ? Json(read_indices(value_, arrays_)) : value_));
  }
  std::string operator()(const ChoiceList&) const { return read_option(option_, to_texts(value_)); }
  std::string operator()(const auto&) const { return as_text(); }

 private:
  std::string as_text() const { return read_option(option_, {to_text(value_).value_or(value_.dump())}); }
  std::string no_flag() const { return gvd::quoted(value_.dump()) + " is neither true nor false"; }
  std::string word() const { return value_.is_string() ? value_.get<std::string>() : ""; }

  const Option& option_;
  const Json& value_;
  const Arrays& arrays_;
  const std::string name_;
};

/// Whether an option took points, curves or numbers from JSON, so that its field does not know how they were given.
bool has_values(const Field& field) {
  return std::visit(
      Overload{[](const PointList&) { return true; }, [](const Curves& curves) { return bool(curves.value->list); },
               [](const ValueSource& values) { return bool(values.value->values); }, [](const auto&) { return false; }},
      field);
}

[[noreturn]] void refuse_name(const OptionList& list, const std::string& wrong) {
  const auto meant = list.suggest(wrong);
  refuse_json(fmt::format("there is no option \"{}\"{}", printable(wrong),
                          meant ? fmt::format("; did you mean \"{}\"?", *meant) : ""));
}

/// Reads one option. Errors begin with its name.
void read(const Option& option, const Json& value, const Arrays& arrays) {
  const std::string name = placeholder(option.name);
  try {
    const std::string wrong = std::visit(OptionReader(option, value, arrays), option.field);
    if (!wrong.empty()) refuse_json(wrong);
  } catch (const Error& error) {
    const bool is_named = first_option(error.text()) == option.name;
    throw is_named ? error : error.at(name);
  }
}

}  // namespace

Given read_json_options(const OptionList& list, const CheckedMesh& input, std::string_view json,
                        std::span<const ArrayView> arrays) {
  Given given;
  const Json parsed = parse(json);
  const Arrays given_arrays{arrays, input};
  for (const auto& [name, value] : parsed.items()) {
    const Option* const option = list.find(name);
    if (option == nullptr) refuse_name(list, name);
    if (value.is_null()) continue;
    read(*option, value, given_arrays);
    // A flag with its default value counts as not given, like --cut=false of a command.
    const bool is_set = !std::holds_alternative<Flag>(option->field) || value.get<bool>() != option->is_on;
    if (is_set) given.add(name, {fmt::format("\"{}\"", name), "", 0, has_values(option->field) ? value.dump() : ""});
  }
  if (const auto problem = list.find_problem(given)) refuse_json(problem->text);
  if (const auto missing = list.find_missing(given)) refuse_json(missing->text);
  return given;
}

namespace {

/// Spells an option as a program of the door writes it, with its value unless that is empty.
std::string spell(Door door, std::string_view name, std::string_view value) {
  const bool is_python = door == Door::python;
  // `from` is a keyword in Python, and in both languages the points are the first argument.
  if (door != Door::json && name == "from") name = "points";
  if (value.empty()) return door == Door::json ? fmt::format("\"{}\"", name) : std::string(name);
  const bool is_flag = value == "true" || value == "false";
  std::string shown(value);
  if (is_python && is_flag) {
    shown = value == "true" ? "True" : "False";
  } else if (!is_flag && !parse_number<double>(value)) {
    shown = door == Door::json ? fmt::format("\"{}\"", value) : gvd::quoted(shown);
  }
  if (door == Door::json) return fmt::format("\"{}\": {}", name, shown);
  return fmt::format("{}{}{}", name, is_python ? "=" : ": ", shown);
}

}  // namespace

std::string spell_for(Door door, const std::string& text) { return spell_for(door, text, OptionList(), Given()); }

std::string spell_for(Door door, const std::string& text, const OptionList& list, const Given& given) {
  return spell_options(
      text, {.spell = [door](std::string_view name, std::string_view value) { return spell(door, name, value); },
             .is_given = [&](std::string_view name) { return given.has(name); },
             .can_give = [&](std::string_view name) { return list.can_add(name, given); }});
}

}  // namespace gvd
