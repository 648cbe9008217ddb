// Completion of `gvd COMMAND ...`. The scripts of the commands are parts of it: that of bash defines a function, that
// of zsh becomes one, and the lines of fish are repeated for gvd, each with a condition.

#include "common/options/program_completion.hpp"

#include <fmt/format.h>

namespace gvd::app {
namespace {

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

/// `script` with `from` replaced where a line begins with it.
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

std::string make_program_completion(const std::vector<CompletedCommand>& commands, const std::string& shell) {
  const auto make = shell == "bash" ? join_bash : shell == "zsh" ? join_zsh : join_fish;
  return make(commands);
}

}  // namespace gvd::app
