#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gvd::app {

/// An option as --help shows it.
struct OptionText {
  std::string names;        ///< "-n,--count"; a name without dashes is a required positional argument
  std::string type;         ///< what stands for the value: "FILE"
  std::string description;  ///< one line
  std::string group = "";   ///< heading in --help; empty: "Options"
  std::string needs = "";   ///< name of an option, added before, without which this one is refused
};

/// Stores the value of an option. Returns what is wrong with it, or nothing.
using StoreValue = std::function<std::optional<std::string>(const std::string&)>;

/// Stores all values of an option that may be repeated.
using StoreList = std::function<void(const std::vector<std::string>&)>;

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
  /// An option that names a TOML file with more options. What the command line gives is kept.
  void add_config(const OptionText& option);

  /// Parses and stores. Returns the text that --help or --version asks for, or nothing.
  /// Throws Error{invalid_option} that names the option.
  std::optional<std::string> parse(int argc, const char* const* argv);

 private:
  struct Parser;
  std::unique_ptr<Parser> parser_;
};

}  // namespace gvd::app
