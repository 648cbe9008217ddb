#pragma once

#include <CLI/CLI.hpp>
#include <istream>
#include <string>
#include <vector>

namespace gvd::app {

/// The TOML file of --config, for CLI11. A key is a name of an option without its dashes; "INPUT" is `input`.
///
/// The command line goes before the file. Of the file, an option is left out that the line
/// 1. gives too;
/// 2. excludes: a file's `n` goes where the line has --vertices;
/// 3. leaves without an option that it needs: a file's `up` goes where the line excludes --view.
class ConfigFile : public CLI::Config {
 public:
  explicit ConfigFile(const CLI::App& app) : app_(app) {}

  /// The options that the file gives, in its order. To be called once the line is parsed.
  /// Throws Error{invalid_option} with file, line, key and what was expected: where it is no TOML, a key is no option,
  /// two keys name one option, or a value has a wrong type.
  std::vector<CLI::ConfigItem> from_config(std::istream& input) const override;

  /// "file:line:column" of the key that gave an option; empty where none did.
  std::string place_of(const CLI::Option* option) const;

  /// A message of CLI11 with the place in front, and keys for the options that the file gives. Without any: as it is.
  std::string with_place(const std::string& message) const;

  /// Nothing: no command writes such a file.
  std::string to_config(const CLI::App*, bool, bool, std::string) const override { return ""; }

 private:
  struct Given {
    const CLI::Option* option;
    std::string key;
    std::string place;
  };

  const CLI::App& app_;
  mutable std::vector<Given> given_;  ///< CLI11 calls `from_config` as const, and does not keep places
};

/// Whether the command line, or what has been read of the file, has `option`. A flag that is off is not given.
bool is_given(const CLI::Option& option);

}  // namespace gvd::app
