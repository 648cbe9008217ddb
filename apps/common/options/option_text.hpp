#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace gvd::app {

/// What a value has to be in a TOML file.
enum class ValueKind { text, whole, number, size, flag };

/// An option as --help shows it, and what it goes together with. Other options are named as a user would type them:
/// "--radius", or with one of their values "--method gbgvd".
struct OptionText {
  std::string names;                       ///< "-n,--count"; a name without dashes is a required positional argument
  std::string type;                        ///< what stands for the value: "FILE"
  std::string description;                 ///< one line
  std::string group = "";                  ///< heading in --help; empty: "Options"
  std::vector<std::string> needs = {};     ///< the option does nothing, and is refused, without one of these
  std::vector<std::string> excludes = {};  ///< the option is refused beside any of these
  ValueKind kind = ValueKind::text;
  /// Of a flag: why it does nothing beside the values of other options, or nothing where it does something. Asked once
  /// all values are stored. Such a flag is refused, unless a file has it and the command line one of `depends_on`.
  std::function<std::optional<std::string>()> idle = {};
  std::vector<std::string> depends_on = {};
};

/// Stores the value of an option. Returns what is wrong with it, or nothing.
using StoreValue = std::function<std::optional<std::string>(const std::string&)>;

/// Stores all values of an option that may be repeated. Throws Error{invalid_option} where one is wrong.
using StoreList = std::function<void(const std::vector<std::string>&)>;

/// An option that a command has.
struct DeclaredOption {
  OptionText text;
  bool is_list = false;
  std::function<std::optional<std::string>(const std::vector<std::string>&)> store;
};

/// An option that a user gave. A flag has the value "true" or "false".
struct GivenOption {
  const DeclaredOption* option = nullptr;
  std::string name;   ///< for messages: "-n", or its key in a file
  std::string place;  ///< file:line:column; empty: the command line
  std::vector<std::string> values;
};

/// A text of the user's for a message: blanks for control characters, and "..." after `longest` bytes.
std::string printable(std::string text, std::size_t longest = 60);

/// "-n,--count" as its names.
std::vector<std::string> split_names(const std::string& names);

/// Whether `given` is what `wanted` names: "--method" or "--method gbgvd". A flag that is false is not.
bool is_given_as(const GivenOption& given, const std::string& wanted);

}  // namespace gvd::app
