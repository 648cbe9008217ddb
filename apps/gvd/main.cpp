// gvd: all commands in one program. `gvd segment ...` does the same as `gvd-segment ...`, which is a link to this
// program.
//
// The name by which the program was called selects the command; if it is not the name of a command, the first word
// does. In both cases a command calls itself gvd-segment in its messages, its help and the report, so that these have
// the same bytes, and agree with the man pages and the documents.

#include <fmt/format.h>
#ifdef __linux__
#include <sys/auxv.h>
#endif

#include <algorithm>
#include <array>
#include <filesystem>
#include <ostream>

#include "common/command.hpp"
#include "common/options/completion.hpp"
#include "common/options/help.hpp"
#include "common/options/options.hpp"
#include "common/options/spelling.hpp"
#include "common/outcome.hpp"
#include "common/process.hpp"
#include "gvd/error.hpp"
#include "gvd/option_list.hpp"
#include "gvd/option_text.hpp"
#include "gvd/text.hpp"
#include "gvd/version.hpp"

namespace gvd::app {

// Each is defined in the main.cpp of its folder.
Command segment_command();
Command lloyd_command();
Command remesh_command();
Command distance_command();

namespace {

namespace fs = std::filesystem;

struct NamedCommand {
  const char* name;
  Command (*make)();
};

constexpr std::array kCommands{NamedCommand{"segment", segment_command}, NamedCommand{"lloyd", lloyd_command},
                               NamedCommand{"remesh", remesh_command}, NamedCommand{"distance", distance_command}};

/// The number of links that Linux follows from a name to a program.
constexpr int kMostLinks = 40;

constexpr const char* kHint = " (see gvd --help)";

constexpr std::string_view kPrefix = "gvd-";

/// The command that a word names, as segment or gvd-segment; null if there is none.
const NamedCommand* find_command(const std::string& word) {
  const std::string name = word.substr(word.starts_with(kPrefix) ? kPrefix.size() : 0);
  const auto found =
      std::find_if(kCommands.begin(), kCommands.end(), [&](const NamedCommand& e) { return name == e.name; });
  return found == kCommands.end() ? nullptr : &*found;
}

/// The path of the program as the shell found it, or as the caller gave it.
fs::path called_path(const char* called) {
  fs::path path = called;
#ifdef __linux__
  const auto* const found = reinterpret_cast<const char*>(getauxval(AT_EXECFN));
  if (!path.has_parent_path() && found != nullptr) return found;
#endif
  return path;
}

/// The command as which the program was called: by the name `called`, or by a link on the way to the program, such as a
/// user's own link to gvd-segment. Null if it was called as gvd or by an unknown name.
const NamedCommand* find_called(const char* called) {
  const auto find = [](const fs::path& path) {
    const std::string name = path.filename().string();
    return name.starts_with(kPrefix) ? find_command(name) : nullptr;
  };
  if (const NamedCommand* const command = find(called)) return command;
  fs::path path = called_path(called);
  for (int links = 0; links < kMostLinks && path.filename() != "gvd"; ++links) {
    if (const NamedCommand* const command = find(path)) return command;
    std::error_code no_link;
    const fs::path target = fs::read_symlink(path, no_link);
    if (no_link) break;
    path = path.parent_path() / target;
  }
  return nullptr;
}

/// The text of `gvd --help`.
std::string make_overview() {
  constexpr std::size_t kWidth = 80, kColumn = 12;
  std::string commands, examples;
  for (const NamedCommand& entry : kCommands) {
    const CommandInfo info = entry.make().info;
    commands += fmt::format("  {:{}}{}\n", entry.name, kColumn - 2, wrap(info.description, kWidth - kColumn, kColumn));
    const std::string first = info.examples.substr(0, info.examples.find('\n') + 1);
    examples += std::string(first).replace(first.find(kPrefix), kPrefix.size(), "gvd ");
  }
  return "Computes Voronoi diagrams on triangle meshes, with distances along the surface.\n\n"
         "Usage: gvd COMMAND [OPTIONS] INPUT...\n\n"
         "Commands:\n" +
         commands +
         "\n"
         "See 'gvd help COMMAND' for all options of a command. Each one is also a program:\n"
         "'gvd segment' is 'gvd-segment'.\n"
         "\nOptions:\n"
         "  -h, --help              Show this\n"
         "  --version               Show the version\n"
         "  --completion bash|zsh|fish\n"
         "                          Print the script that completes gvd and its commands\n"
         "                          in a shell\n" +
         help_footer(examples);
}

std::string make_all_completions(const std::string& shell) {
  std::vector<CompletedCommand> commands;
  for (const NamedCommand& entry : kCommands) {
    const Command command = entry.make();
    commands.push_back({entry.name, command.info.description, make_completion(command, shell)});
  }
  return make_program_completion(commands, shell) + "\n";
}

/// Refuses a word that is no command and no option of gvd.
[[noreturn]] void refuse_word(const std::string& word) {
  const bool is_option = word.size() > 1 && word.starts_with('-');
  std::vector<std::string> names{"help"};
  for (const NamedCommand& entry : kCommands) names.emplace_back(entry.name);
  if (is_option) names = {"--help", "--version", "--completion"};
  const auto meant = suggest_name(word, names);
  std::error_code ignored;
  const bool is_input = word == "-" || fs::path(word).has_extension() || fs::exists(word, ignored);
  const char* const advice = meant       ? " (did you mean {1}?)"
                             : is_option ? "; options of a command follow its name, as in gvd segment {0}"
                             : is_input  ? "; name a command in front of it, as in gvd segment {0}"
                                         : "";
  const std::string form = fmt::format("unknown {}: {{0}}{}{}", is_option ? "option" : "command", advice, kHint);
  throw Error(ErrorCode::invalid_option, fmt::format(fmt::runtime(form), user_text(word), meant.value_or("")));
}

/// The shell of `--completion SHELL` or `--completion=SHELL`.
std::string read_shell(const std::vector<std::string>& words) {
  Shell shell{};
  OptionList list;
  list.option("completion", choice(shell, kShells), {});
  const std::size_t equals = words[0].find('=');
  std::vector<std::string> values(words.begin() + 1, words.end());
  if (equals != words[0].npos) values.insert(values.begin(), words[0].substr(equals + 1));
  const std::string wrong = read_option(*list.find("completion"), values);
  if (!wrong.empty()) {
    refuse_option(list, {}, {"completion", words[0].substr(0, equals) + ": " + wrong}, kHint);
  }
  return values.front();
}

bool asks_for_help(const std::string& word) { return word == "help" || word == "--help" || word == "-h"; }

/// The answer of gvd itself to words that call no command.
std::string answer(const std::vector<std::string>& words) {
  if (words.empty()) return make_overview();
  const std::string& first = words[0];
  const std::string option = first.substr(0, first.find('='));
  const bool is_alone = words.size() == 1 || asks_for_help(words[1]);  // "gvd help help", too
  if (asks_for_help(first) && is_alone) return make_overview();
  if (asks_for_help(first)) refuse_word(words[1]);
  if (first == "version" || first == "--version") return fmt::format("gvd {}\n", version());
  if (option == "--completion" || option == "--print-completion") return make_all_completions(read_shell(words));
  refuse_word(first);
}

int print_answer(const std::vector<std::string>& words) {
  return run_process("gvd", [&] {
    const std::string said = answer(words);
    write_standard_output([&](std::ostream& out) { out << said; });
    return words.empty() ? kUsage : kDone;  // as git does
  });
}

}  // namespace
}  // namespace gvd::app

int main(int argc, char** argv) {
  using namespace gvd::app;
  const std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  if (const NamedCommand* const command = find_called(argc > 0 ? argv[0] : "gvd"))
    return run_command(command->make(), argc, argv);
  if (words.empty()) return print_answer(words);
  if (const NamedCommand* const command = find_command(words[0]))
    return run_command(command->make(), argc - 1, argv + 1);
  if (words.size() > 1 && asks_for_help(words[0])) {
    const std::array<const char*, 2> question{argv[0], words[0] == "-h" ? "-h" : "--help"};
    if (const NamedCommand* const command = find_command(words[1]))
      return run_command(command->make(), 2, question.data());
  }
  return print_answer(words);
}
