#pragma once

#include <string>
#include <vector>

namespace gvd::app {

/// A value of a TOML file.
struct ConfigValue {
  enum class Type { text, whole, number, flag, other };
  Type type = Type::other;
  std::string type_name;  ///< for messages: "a string"
  std::string text;       ///< as it would be typed on a command line; empty for `other`
  std::string place;      ///< file:line:column
};

/// A key of a TOML file and its value, or the values of its array.
struct ConfigEntry {
  std::string key;
  std::string place;  ///< file:line:column of the key
  bool is_array = false;
  std::vector<ConfigValue> values;
};

/// The entries of a TOML file, in its order. Tables and dates are values of the type `other`.
/// Throws Error{invalid_option} with the place where the file can't be read or is no TOML.
std::vector<ConfigEntry> read_config_file(const std::string& path);

/// The same for the content of a file. `name` is the file's, for messages.
std::vector<ConfigEntry> parse_config(const std::string& content, const std::string& name);

}  // namespace gvd::app
