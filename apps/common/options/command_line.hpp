#pragma once

#include <memory>
#include <optional>
#include <string>

#include "common/options/option_text.hpp"

namespace gvd::app {

/// The options of a command and their parser. It hides CLI11, a header that takes many seconds to compile.
/// Every target of an option must outlive it.
class CommandLine {
 public:
  /// `version` and `footer` are texts of --version and --help.
  CommandLine(const std::string& name, const std::string& description, const std::string& version,
              const std::string& footer);
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  /// An option that takes one value.
  void add_value(const OptionText& option, const StoreValue& store);
  /// An option that may be repeated, with one value each time.
  void add_list(const OptionText& option, const StoreList& store);
  /// An option without a value; `option.type` is not used.
  void add_flag(const OptionText& option, bool& target);
  /// An option that names a TOML file with more options, and stores its name. The command line overrides the file: see
  /// merge_options.
  void add_config(const OptionText& option, std::string& target);

  /// Parses and stores. Returns the text that --help or --version asks for, or nothing.
  /// Throws Error{invalid_option} that names the option and, where it comes from a file, file, line and column.
  std::optional<std::string> parse(int argc, const char* const* argv);

 private:
  struct Parser;
  std::unique_ptr<Parser> parser_;
};

}  // namespace gvd::app
