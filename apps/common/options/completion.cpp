// Makes completion scripts from the same table of options as --help. Each shell has its own form for the same facts:
// the names of an option, the words and kinds of files that may follow, and one line of description.

#include "common/options/completion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "common/options/spelling.hpp"
#include "gvd/generator_list.hpp"
#include "gvd/option_text.hpp"

namespace gvd::app {
namespace {

/// An option, or INPUT, as completion offers it.
struct CompletedOption {
  std::vector<std::string> short_names, long_names;  ///< without dashes; none for INPUT
  std::string description;
  std::string type;  ///< as --help shows it
  bool takes_value = false;
  bool is_repeatable = false;
  std::vector<std::string> words = {};
  bool is_list = false;    ///< several words are separated by commas
  std::string files = {};  ///< "any", "folder", or extensions separated by "|"; empty: no file

  /// The names as typed, with `separator` between them and `suffix` after long ones.
  std::string names(const char* separator, const char* suffix = "") const {
    std::vector<std::string> typed;
    for (const std::string& name : short_names) typed.push_back("-" + name);
    for (const std::string& name : long_names) typed.push_back("--" + name + suffix);
    return fmt::format("{}", fmt::join(typed, separator));
  }
};

/// Adds the words and files that an option takes.
void add_values(CompletedOption& option, const Field& field) {
  const auto words = [&](const auto& names) { option.words.assign(names.begin(), names.end()); };
  const auto nothing = [](const auto&) {};
  std::visit(Overload{[&](const Switch&) {
                        words(std::array{"on", "off"});
                      },
                      [&](const Number& number) { words(names_in(number.words)); },
                      [&](const Choice& choice) { words(choice.names); },
                      [&](const ChoiceList& list) {
                        words(list.names);
                        option.is_list = true;
                      },
                      [&](const File& file) {
                        const bool is_folder = file.use == File::Use::folder;
                        option.files = is_folder                 ? "folder"
                                       : file.extensions.empty() ? "any"
                                                                 : fmt::format("{}", fmt::join(file.extensions, "|"));
                      },
                      [&](const PointList& list) {
                        const bool names_files = list.named != PointList::Named::vertices;
                        option.files = names_files ? fmt::format("{}", fmt::join(generator_extensions(), "|")) : "";
                      },
                      [&](const Curves&) {
                        words(std::array{"boundary", "creases"});
                        option.files = "any";
                      },
                      [&](const ValueSource& values) {
                        words(values.words);
                        option.files = "any";
                      },
                      [&](const CreaseAngle&) {
                        words(std::array{"auto", "none"});
                      },
                      nothing},
             field);
}

CompletedOption make_completed_option(const OptionList& list, const Option& entry) {
  CompletedOption option;
  for (const std::string& name : typed_names(entry)) {
    if (name.starts_with("--")) option.long_names.push_back(name.substr(2));
    if (!name.starts_with("--") && name.starts_with('-')) option.short_names.push_back(name.substr(1));
  }
  option.description = spell(list, entry.spec.help);
  option.type = entry.spec.positional ? "FILE" : value_name(entry.field);
  option.takes_value = takes_value(entry.field);
  option.is_repeatable = option.takes_value && is_repeatable(entry.field);
  add_values(option, entry.field);
  return option;
}

/// The options that --help lists. The positional option has no name.
std::vector<CompletedOption> list_completed_options(const OptionList& list) {
  std::vector<CompletedOption> options;
  for (const Option* const option : list.options()) {
    if (option->spec.shown != Shown::hidden) options.push_back(make_completed_option(list, *option));
  }
  return options;
}

std::string replace_all(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != text.npos; at += to.size()) text.replace(at, from.size(), to);
  return text;
}

/// Puts a backslash before each of the characters `special` in `text`.
std::string escape_with_backslash(const std::string& text, std::string_view special) {
  std::string escaped;
  for (const char c : text) {
    if (special.find(c) != special.npos) escaped += '\\';
    escaped += c;
  }
  return escaped;
}

// Names of files are completed last, so that mapfile appends them. compopt fails if no completion is running, as in
// tests.
constexpr const char* kBashScript = R"(# Completion of {0} for bash, made by {0} --print-completion bash
{1}() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} option=${{COMP_WORDS[COMP_CWORD-1]}} words= files= list=
  if [[ $word == = ]]; then
    word=
  elif [[ $option == = ]]; then
    option=${{COMP_WORDS[COMP_CWORD-2]}}
  fi
  case $option in
{2}    *) if [[ $word == -* ]]; then words='{3}'; else files='{4}'; fi ;;
  esac
  if [[ $list && $word == *,* ]]; then
    local chosen=${{word%,*}} offered=
    for option in $words; do
      [[ ,$chosen, == *,$option,* ]] || offered+=" $chosen,$option"
    done
    words=$offered
  fi
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
  std::string cases, inputs;
  std::vector<std::string> names;
  for (const CompletedOption& option : options) {
    if (option.names("").empty()) inputs = option.files;
    if (const std::string typed = option.names(" "); !typed.empty()) names.push_back(typed);
    if (!option.takes_value || option.names("").empty()) continue;
    cases += fmt::format("    {}) words='{}' files='{}'{} ;;\n", option.names("|"), fmt::join(option.words, " "),
                         option.files, option.is_list ? " list=1" : "");
  }
  const std::string function = "_" + replace_all(command, "-", "_");
  return fmt::format(fmt::runtime(kBashScript), command, function, cases, fmt::join(names, " "), inputs);
}

/// The action of _arguments for a value.
std::string zsh_action(const CompletedOption& option) {
  const bool has_several = option.files.find('|') != option.files.npos;
  const std::string extensions = has_several ? "(" + option.files + ")" : option.files;
  const std::string files = option.files.empty()       ? ""
                            : option.files == "any"    ? "_files"
                            : option.files == "folder" ? "_files -/"
                                                       : fmt::format("_files -g \"*.{}\"", extensions);
  if (option.words.empty()) return files.empty() ? " " : files;
  const std::string words = fmt::format("{}", fmt::join(option.words, " "));
  if (option.is_list) return fmt::format("_values -s , value {}", words);
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
    const std::string description = replace_all(escape_with_backslash(option.description, "\\[]:"), "'", "'\\''");
    script += fmt::format(" \\\n  '{}{}[{}]{}'", excluded, typed, description, value);
  }
  return script;
}

/// The arguments of `complete` for files with some extensions.
std::vector<std::string> fish_files(const std::string& files) {
  if (files == "folder") return {"(__fish_complete_directories)"};
  std::vector<std::string> words;
  for (std::size_t start = 0; !files.empty() && files != "any" && start <= files.size();) {
    const std::size_t end = std::min(files.find('|', start), files.size());
    words.push_back(fmt::format("(__fish_complete_suffix .{})", files.substr(start, end - start)));
    start = end + 1;
  }
  return words;
}

/// The arguments of `complete` for a value.
std::string fish_value(const CompletedOption& option) {
  if (!option.takes_value) return "";
  std::vector<std::string> words = option.words;
  if (option.is_list) {
    // The second part drops lists whose last word occurs already.
    words = {
        fmt::format(R"((__fish_complete_list , "printf %s\\n {}" | string match -rv "(^|[=,])([^,]+),(.*,)?\\\\2\\$"))",
                    fmt::join(option.words, " "))};
  }
  for (std::string& file : fish_files(option.files)) words.push_back(std::move(file));
  const std::string listed = words.empty() ? "" : fmt::format(" -a '{}'", fmt::join(words, " "));
  return (option.files == "any" ? " -r -F" : " -x") + listed;
}

std::string make_fish(const std::string& command, const std::vector<CompletedOption>& options) {
  std::string script = fmt::format("# Completion of {0} for fish, made by {0} --print-completion fish", command);
  for (const CompletedOption& option : options) {
    script += "\ncomplete -c " + command;
    if (option.names("").empty()) {
      script += fmt::format(" -x -a '{}'", fmt::join(fish_files(option.files), " "));
      continue;
    }
    for (const std::string& name : option.short_names) script += " -s " + name;
    for (const std::string& name : option.long_names) script += " -l " + name;
    script += fmt::format("{} -d '{}'", fish_value(option), escape_with_backslash(option.description, "\\'"));
  }
  return script;
}

// ---- the program gvd: in bash, the script of a command defines a function; in zsh, it becomes a function; and in
// fish, its lines are repeated for gvd, each with a condition.

// {0}: the commands' scripts, {1}: their names, {2}: their cases
constexpr const char* kBashOfProgram = R"({0}
# Completion of gvd for bash, made by gvd --completion bash
_gvd() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} words='{1}'
  if ((COMP_CWORD == 1)); then
    words+=' help'
    if [[ $word == -* ]]; then words='-h --help --version --completion'; fi
  else
    case ${{COMP_WORDS[1]#gvd-}} in
{2}      help) ((COMP_CWORD == 2)) || words= ;;
      --completion) words='bash zsh fish' ;;
      *) words= ;;
    esac
  fi
  if [[ $word == = ]]; then word=; fi
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
}}
complete -F _gvd gvd)";

// {0}: the commands' functions, {1}: their names, {2}: the same with descriptions, {3}: cases
constexpr const char* kZshOfProgram = R"(#compdef gvd{1}
# Completion of gvd for zsh, made by gvd --completion zsh
{0}
case ${{service#gvd-}} in
{3}esac
local curcontext=$curcontext context state state_descr line
local -A opt_args
local -a commands=(
{2})
local -a words_of_gvd=($commands 'help:Show all options of a command')
_arguments -C -A '-*' \
  '(- : *)'{{-h,--help}}'[Show the commands]' \
  '(- : *)--version[Show the version]' \
  '(- : *)--completion=[Print the script that completes gvd in a shell]:SHELL:(bash zsh fish)' \
  '1:command:->command' '*::argument:->argument' && return
case $state in
  command) _describe -t commands command words_of_gvd; return ;;
esac
case ${{words[1]#gvd-}} in
{3}  help) ((CURRENT > 2)) || _describe -t commands command commands ;;
esac)";

// {0}: the commands' lines, {1}: their names
constexpr const char* kFishOfProgram = R"({0}
# Completion of gvd for fish, made by gvd --completion fish
function __gvd_runs
  set -l typed (commandline -opc)
  test (count $typed) -ge 2; and test (string replace -r "^gvd-" "" -- $typed[2]) = $argv[1]
end
function __gvd_begins
  set -l typed (commandline -opc)
  test (count $typed) -eq 1; or test "$typed[2..-1]" = --completion
end
{1}complete -c gvd -n __gvd_begins -f -a help -d 'Show all options of a command'
complete -c gvd -n __gvd_begins -s h -l help -d 'Show the commands'
complete -c gvd -n __gvd_begins -l version -d 'Show the version'
complete -c gvd -n __gvd_begins -l completion -x -a 'bash zsh fish' -d 'Print the script that completes gvd in a shell')";

/// Replaces `from` in a script wherever a line begins with it.
std::string replace_beginnings(std::string script, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = script.find(from, at)) != script.npos; at += to.size()) {
    if (at == 0 || script[at - 1] == '\n') script.replace(at, from.size(), to);
  }
  return script;
}

std::string join_bash(const std::vector<CompletedCommand>& commands) {
  std::string scripts, names, cases;
  for (const CompletedCommand& command : commands) {
    scripts += command.script + '\n';
    names += (names.empty() ? "" : " ") + command.name;
    cases += fmt::format("      {0}) _gvd_{0}; return ;;\n", command.name);
  }
  scripts.pop_back();
  return fmt::format(fmt::runtime(kBashOfProgram), scripts, names, cases);
}

std::string join_zsh(const std::vector<CompletedCommand>& commands) {
  std::string functions, names, described, cases;
  for (const CompletedCommand& command : commands) {
    functions += fmt::format("_gvd_{}() {{\n{}\n}}\n", command.name, command.script);
    names += " gvd-" + command.name;
    described += fmt::format("  '{}:{}'\n", command.name, command.description);
    cases += fmt::format("  {0}) _gvd_{0}; return ;;\n", command.name);
  }
  functions.pop_back();
  return fmt::format(fmt::runtime(kZshOfProgram), functions, names, described, cases);
}

std::string join_fish(const std::vector<CompletedCommand>& commands) {
  std::string scripts, names;
  for (const CompletedCommand& command : commands) {
    const std::string& name = command.name;
    scripts += command.script + '\n' +
               replace_beginnings(command.script, "complete -c gvd-" + name,
                                  fmt::format("complete -c gvd -n '__gvd_runs {}'", name)) +
               '\n';
    names += fmt::format(
        "complete -c gvd -n __gvd_begins -f -a {0} -d '{1}'\n"
        "complete -c gvd -n '__gvd_runs help; and test (count (commandline -opc)) -eq 2' -f -a {0} -d '{1}'\n",
        name, command.description);
  }
  scripts.pop_back();
  return fmt::format(fmt::runtime(kFishOfProgram), scripts, names);
}

}  // namespace

std::string make_completion(const std::string& command, const OptionList& list, const std::string& shell) {
  const auto make = shell == "bash" ? make_bash : shell == "zsh" ? make_zsh : make_fish;
  return make(command, list_completed_options(list));
}

std::string make_program_completion(const std::vector<CompletedCommand>& commands, const std::string& shell) {
  const auto make = shell == "bash" ? join_bash : shell == "zsh" ? join_zsh : join_fish;
  return make(commands);
}

}  // namespace gvd::app
