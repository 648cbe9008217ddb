#include "common/options/config_options.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "common/options/suggest_name.hpp"
#include "gvd/error.hpp"

namespace gvd::app {
namespace {

using Type = ConfigValue::Type;

[[noreturn]] void refuse(const std::string& place, const std::string& key, const std::string& message) {
  throw Error(ErrorCode::invalid_option, fmt::format("{}: {}: {}", place, printable(key), message));
}

/// "--input-format" as "input-format", and "INPUT" as "input".
std::string key_of(std::string name) {
  if (name.front() == '-') return name.substr(name.find_first_not_of('-'));
  std::transform(name.begin(), name.end(), name.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return name;
}

bool has_key(const DeclaredOption& option, const std::string& key) {
  const std::vector<std::string> names = split_names(option.text.names);
  return std::any_of(names.begin(), names.end(), [&](const std::string& name) { return key_of(name) == key; });
}

const DeclaredOption& find_option(const ConfigEntry& entry, const std::deque<DeclaredOption>& declared) {
  std::vector<std::string> keys;
  for (const DeclaredOption& option : declared) {
    if (has_key(option, entry.key)) return option;
    for (const std::string& name : split_names(option.text.names)) keys.push_back(key_of(name));
  }
  if (!entry.is_array && entry.values.front().type_name == "a table") {
    refuse(entry.place, entry.key, "is a table; write its keys without one");
  }
  if (const auto meant = suggest_name(entry.key, keys)) {
    refuse(entry.place, entry.key, fmt::format("is no option; did you mean {}?", *meant));
  }
  refuse(entry.place, entry.key, "is no option; keys are the names of options without dashes in front: input-format");
}

std::string expected(const DeclaredOption& option) {
  switch (option.text.kind) {
    case ValueKind::whole:
      return option.is_list ? "an array of whole numbers, as [3, 17], or a string, as \"3,17\"" : "a whole number";
    case ValueKind::number:
      return "a number";
    case ValueKind::size:
      return "a string such as \"2G\", or a number of bytes";
    case ValueKind::flag:
      return "true or false";
    case ValueKind::text:
      break;
  }
  return option.is_list ? "a string, or an array of strings" : "a string in quotes";
}

bool fits(Type type, const DeclaredOption& option) {
  switch (option.text.kind) {
    case ValueKind::whole:
      return type == Type::whole || (option.is_list && type == Type::text);
    case ValueKind::number:
      return type == Type::whole || type == Type::number;
    case ValueKind::size:
      return type == Type::whole || type == Type::number || type == Type::text;
    case ValueKind::flag:
      return type == Type::flag;
    case ValueKind::text:
      break;
  }
  return type == Type::text;
}

std::vector<std::string> values_of(const ConfigEntry& entry, const DeclaredOption& option) {
  const auto wrong = [&](const std::string& place, const std::string& found) {
    refuse(place, entry.key, fmt::format("expected {}, found {}", expected(option), found));
  };
  if (entry.is_array && !option.is_list) wrong(entry.place, "an array");
  if (entry.values.empty()) wrong(entry.place, "an empty array");
  std::vector<std::string> values;
  for (const ConfigValue& value : entry.values) {
    if (!fits(value.type, option)) wrong(value.place, value.type_name);
    values.push_back(value.text);
  }
  return values;
}

}  // namespace

std::vector<GivenOption> find_config_options(const std::vector<ConfigEntry>& entries,
                                             const std::deque<DeclaredOption>& declared) {
  std::vector<GivenOption> given;
  for (const ConfigEntry& entry : entries) {
    const DeclaredOption& option = find_option(entry, declared);
    for (const GivenOption& earlier : given) {
      if (earlier.option == &option) refuse(entry.place, entry.key, "is the same option as " + earlier.name + " above");
    }
    given.push_back({&option, entry.key, entry.place, values_of(entry, option)});
  }
  return given;
}

}  // namespace gvd::app
