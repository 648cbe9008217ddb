// Completion scripts, from the same table of options as --help. Each shell has a form of its own for the same facts:
// the names of an option, the words and kinds of files that may follow, and one line of description.

#include "common/options/completion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "common/options/command_line.hpp"

namespace gvd::app {
namespace {

/// What may stand behind an option, or in its place.
struct CompletedOption {
  std::vector<std::string> short_names, long_names;  ///< without dashes; none for INPUT
  std::string description;
  std::string type;  ///< as --help shows it
  bool takes_value = false;
  bool is_repeatable = false;
  std::vector<std::string> words = {};
  std::string files = {};  ///< "any", "folder", or their extensions, parted by "|"; empty: no file

  /// Its names as typed, with `separator` between them, and `suffix` behind the long ones.
  std::string names(const char* separator, const char* suffix = "") const {
    std::vector<std::string> typed;
    for (const std::string& name : short_names) typed.push_back("-" + name);
    for (const std::string& name : long_names) typed.push_back("--" + name + suffix);
    return fmt::format("{}", fmt::join(typed, separator));
  }
};

void add_alternative(CompletedOption& option, const std::string& text) {
  const auto is_small = [](char c) { return c >= 'a' && c <= 'z'; };
  if (text == "FILE") {
    option.files = "any";
  } else if (text == "DIR") {
    option.files = "folder";
  } else if (std::any_of(text.begin(), text.end(), is_small)) {
    option.words.push_back(text);
  }
}

CompletedOption make_completed_option(const CLI::Option& entry) {
  CompletedOption option{entry.get_snames(), entry.get_lnames(), first_clause(entry.get_description()),
                         entry.get_type_name()};
  option.takes_value = entry.get_items_expected_max() > 0;
  option.is_repeatable = entry.get_items_expected_max() > 1;
  if (entry.get_positional()) option.type = "FILE";
  constexpr std::string_view kWithExtension = "FILE.";
  if (option.type.starts_with(kWithExtension)) {
    option.files = option.type.substr(kWithExtension.size());
  } else {
    for (const std::string& text : CLI::detail::split(option.type, '|')) add_alternative(option, text);
  }
  return option;
}

/// The options that --help lists. The positional one comes without a name.
std::vector<CompletedOption> list_completed_options(const CLI::App& app) {
  std::vector<CompletedOption> options;
  for (const CLI::Option* const option : app.get_options()) {
    if (!option->get_group().empty()) options.push_back(make_completed_option(*option));
  }
  return options;
}

/// `text` with a backslash before each of `special`.
std::string escape_with_backslash(const std::string& text, std::string_view special) {
  std::string escaped;
  for (const char c : text) {
    if (special.find(c) != special.npos) escaped += '\\';
    escaped += c;
  }
  return escaped;
}

// Names of files are completed last, so that mapfile appends them. compopt fails where no completion runs, as in tests.
constexpr const char* kBashScript = R"(# Completion of {0} for bash, made by {0} --print-completion bash
{1}() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} option=${{COMP_WORDS[COMP_CWORD-1]}} words= files=
  if [[ $word == = ]]; then
    word=
  elif [[ $option == = ]]; then
    option=${{COMP_WORDS[COMP_CWORD-2]}}
  fi
  case $option in
{2}    *) if [[ $word == -* ]]; then words='{3}'; else files=any; fi ;;
  esac
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
  case $files in
    '') return ;;
    any) mapfile -t -O ${{#COMPREPLY[@]}} COMPREPLY < <(compgen -f -- "$word") ;;
    folder) mapfile -t -O ${{#COMPREPLY[@]}} COMPREPLY < <(compgen -d -- "$word") ;;
    *) mapfile -t -O ${{#COMPREPLY[@]}} COMPREPLY < <(compgen -d -- "$word"
         for files in ${{files//|/ }}; do compgen -f -X "!*.$files" -- "$word"; done) ;;
  esac
  compopt -o filenames 2>/dev/null
}}
complete -F {1} {0})";

std::string make_bash(const std::string& command, const std::vector<CompletedOption>& options) {
  std::string cases;
  std::vector<std::string> names;
  for (const CompletedOption& option : options) {
    if (const std::string typed = option.names(" "); !typed.empty()) names.push_back(typed);
    if (!option.takes_value || option.names("").empty()) continue;
    cases += fmt::format("    {}) words='{}' files='{}' ;;\n", option.names("|"), fmt::join(option.words, " "),
                         option.files);
  }
  const std::string function = "_" + CLI::detail::find_and_replace(command, "-", "_");
  return fmt::format(fmt::runtime(kBashScript), command, function, cases, fmt::join(names, " "));
}

/// What _arguments does for the value.
std::string zsh_action(const CompletedOption& option) {
  const bool has_several = option.files.find('|') != option.files.npos;
  const std::string extensions = has_several ? "(" + option.files + ")" : option.files;
  const std::string files = option.files.empty()       ? ""
                            : option.files == "any"    ? "_files"
                            : option.files == "folder" ? "_files -/"
                                                       : fmt::format("_files -g \"*.{}\"", extensions);
  if (option.words.empty()) return files.empty() ? " " : files;
  const std::string words = fmt::format("{}", fmt::join(option.words, " "));
  return files.empty() ? fmt::format("({})", words) : fmt::format("{{compadd - {}; {}}}", words, files);
}

std::string make_zsh(const std::string& command, const std::vector<CompletedOption>& options) {
  std::string script = fmt::format(
      "#compdef {0}\n# Completion of {0} for zsh, made by {0} --print-completion zsh\n_arguments -S", command);
  for (const CompletedOption& option : options) {
    const std::string names = option.names(" ");
    const std::string value = option.takes_value ? fmt::format(":{}:{}", option.type, zsh_action(option)) : "";
    if (names.empty()) {
      script += fmt::format(" \\\n  '*{}'", value);
      continue;
    }
    const std::string excluded = option.is_repeatable ? "*" : fmt::format("({})", names);
    const std::string listed = option.names(",", option.takes_value ? "=" : "");
    const std::string typed = listed.find(',') != listed.npos ? fmt::format("'{{{}}}'", listed) : listed;
    const std::string description =
        CLI::detail::find_and_replace(escape_with_backslash(option.description, "\\[]:"), "'", "'\\''");
    script += fmt::format(" \\\n  '{}{}[{}]{}'", excluded, typed, description, value);
  }
  return script;
}

/// What `complete` says about the value.
std::string fish_value(const CompletedOption& option) {
  if (!option.takes_value) return "";
  std::vector<std::string> words = option.words;
  if (option.files == "folder") words.push_back("(__fish_complete_directories)");
  const bool has_extension = !option.files.empty() && option.files != "any" && option.files != "folder";
  for (const std::string& extension : CLI::detail::split(option.files, '|')) {
    if (has_extension) words.push_back(fmt::format("(__fish_complete_suffix .{})", extension));
  }
  const std::string listed = words.empty() ? "" : fmt::format(" -a '{}'", fmt::join(words, " "));
  return (option.files == "any" ? " -r -F" : " -x") + listed;
}

std::string make_fish(const std::string& command, const std::vector<CompletedOption>& options) {
  std::string script = fmt::format("# Completion of {0} for fish, made by {0} --print-completion fish", command);
  for (const CompletedOption& option : options) {
    if (option.names("").empty()) continue;  // fish completes files anyway
    script += "\ncomplete -c " + command;
    for (const std::string& name : option.short_names) script += " -s " + name;
    for (const std::string& name : option.long_names) script += " -l " + name;
    script += fmt::format("{} -d '{}'", fish_value(option), escape_with_backslash(option.description, "\\'"));
  }
  return script;
}

}  // namespace

std::string make_completion(const CLI::App& app, const std::string& shell) {
  const auto make = shell == "bash" ? make_bash : shell == "zsh" ? make_zsh : make_fish;
  return make(app.get_name(), list_completed_options(app));
}

}  // namespace gvd::app
