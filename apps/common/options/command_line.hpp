#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace gvd::app {

/// An option that does nothing beside some values of others, which CLI11's `needs` and `excludes` can't say. It is
/// refused, unless it comes from --config and the command line has one of `depends_on`: then it is left out.
struct ValueRule {
  CLI::Option* option;
  std::vector<CLI::Option*> depends_on;
  std::function<std::string()> idle;  ///< why it does nothing; empty where it does something
  std::function<void()> leave_out;    ///< stores the value of an option that is not given
};

/// Parses a command line and the file of --config into the targets of the options of `app`, and looks at the rules in
/// their order. Returns the text that --help or --version asks for, or nothing.
/// Throws Error{invalid_option} in one line: the option, what is wrong and, where it comes from a file, file, line and
/// column.
std::optional<std::string> parse_command_line(CLI::App& app, const std::vector<ValueRule>& rules, int argc,
                                              const char* const* argv);

/// The name that `wrong` most likely stands for, or nothing. Dashes in front, a value behind "=", and capitals don't
/// count.
///
/// The same name, or the shortest one whose words begin with those of `wrong`, where that has three letters, or
/// one for "INPUT": "--out-d" or "--outdir" for "--output-dir". Else
/// the name that takes the fewest insertions, deletions, replacements and swaps of neighbours, if there is at most one
/// for each three letters of `wrong`, or one in all. The first of equals is taken. Cost: O(letters) for each letter of
/// each name.
std::optional<std::string> suggest_name(const std::string& wrong, const std::vector<std::string>& names);

/// A description up to its first detail.
std::string first_clause(const std::string& description);

/// The words of `text` in lines of at most `width` columns, all but the first one after `indent` blanks.
std::string wrap(const std::string& text, std::size_t width, std::size_t indent);

/// The help of an app. With the mode All, that of --help, its options are listed in groups, in the order in which each
/// group and each of its options comes first. Otherwise, for -h, the main ones come without details. No line is longer
/// than 80 columns, as long as no single word is.
class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;
  std::string make_option(const CLI::Option* option, bool is_positional) const override;

 private:
  std::string make_main_options(const CLI::App* app) const;
  static std::string make_line(const CLI::Option* option, const std::string& description);
};

}  // namespace gvd::app
