#include "common/options/config_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "common/options/checked_toml.hpp"
#include "common/options/option_text.hpp"
#include "gvd/error.hpp"
#include "gvd/text.hpp"

namespace gvd::app {
namespace {

/// Bytes of the parser's reason that a message repeats: its own words, and a key of moderate length.
constexpr std::size_t kReasonLength = 200;

[[noreturn]] void refuse_file(const std::string& message) { throw Error(ErrorCode::invalid_option, message); }

std::string place_of(const std::string& name, const toml::source_region& region) {
  return fmt::format("{}:{}:{}", name, region.begin.line, region.begin.column);
}

const char* type_name(const toml::node& node) {
  if (node.is_string()) return "a string";
  if (node.is_integer()) return "a whole number";
  if (node.is_floating_point()) return "a number with a fraction";
  if (node.is_boolean()) return "a boolean";
  if (node.is_array()) return "an array";
  return node.is_table() ? "a table" : "a date or a time";
}

ConfigValue read_value(const toml::node& node, const std::string& name) {
  using Type = ConfigValue::Type;
  ConfigValue value{Type::other, type_name(node), "", place_of(name, node.source())};
  if (const auto* const text = node.as_string()) {
    value.type = Type::text;
    value.text = text->get();
  } else if (const auto* const whole = node.as_integer()) {
    value.type = Type::whole;
    value.text = fmt::format("{}", whole->get());
  } else if (const auto* const number = node.as_floating_point()) {
    value.type = Type::number;
    value.text = fmt::format("{}", number->get());
  } else if (const auto* const flag = node.as_boolean()) {
    value.type = Type::flag;
    value.text = flag->get() ? "true" : "false";
  }
  return value;
}

/// The place of a key; before version 3 of the library that of its value.
template <class Key>
std::string key_place(const Key& key, const toml::node& node, const std::string& name) {
  if constexpr (requires { key.source(); }) {
    return place_of(name, key.source());
  } else {
    return place_of(name, node.source());
  }
}

template <class Key>
ConfigEntry read_entry(const Key& key, const toml::node& node, const std::string& name) {
  ConfigEntry entry{std::string(std::string_view(key)), key_place(key, node, name), node.is_array(), {}};
  if (const auto* const array = node.as_array()) {
    for (const toml::node& element : *array) entry.values.push_back(read_value(element, name));
  } else {
    entry.values.push_back(read_value(node, name));
  }
  return entry;
}

/// Entries with their regions: a table of the library is sorted by its keys.
struct PlacedEntry {
  toml::source_position begin;
  ConfigEntry entry;
};

std::vector<ConfigEntry> in_order(const toml::table& table, const std::string& name) {
  std::vector<PlacedEntry> placed;
  for (const auto& [key, node] : table) {
    placed.push_back({node.source().begin, read_entry(key, node, name)});
  }
  std::sort(placed.begin(), placed.end(), [](const PlacedEntry& a, const PlacedEntry& b) { return a.begin < b.begin; });
  std::vector<ConfigEntry> entries;
  for (PlacedEntry& each : placed) entries.push_back(std::move(each.entry));
  return entries;
}

/// "n: " where the last line with a `=` up to `line` begins with the key n; the parser does not tell the key of a value
/// that it can't read.
std::string key_before(const std::string& content, std::size_t line) {
  std::istringstream lines(content);
  std::string key;
  std::string text;
  for (std::size_t i = 0; i < line && std::getline(lines, text); ++i) {
    const std::size_t equals = text.find('=');
    const std::size_t first = text.find_first_not_of(" \t");
    if (equals == text.npos || first >= equals) continue;
    const std::size_t last = text.find_last_not_of(" \t", equals - 1);
    key = printable(text.substr(first, last - first + 1)) + ": ";
  }
  return key;
}

}  // namespace

std::vector<ConfigEntry> parse_config(const std::string& content, const std::string& name) {
  try {
    return in_order(toml::parse(content, name), name);
  } catch (const toml::parse_error& error) {
    const std::string key = key_before(content, error.source().begin.line);
    const std::string reason = printable(std::string(error.description()), kReasonLength);
    refuse_file(fmt::format("{}: {}no TOML: {}", place_of(name, error.source()), key, reason));
  }
}

std::vector<ConfigEntry> read_config_file(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) refuse_file(path + ": is a directory; name a TOML file");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) refuse_file(fmt::format("--config '{}': {}; name a TOML file", path, std::strerror(errno)));
  const std::string content = read_to_end(file);
  if (file.bad()) refuse_file(path + ": could not be read to its end");
  return parse_config(content, path);
}

}  // namespace gvd::app
