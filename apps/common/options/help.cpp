// Formats the help of a command in two columns: the names of options, and what they do.

#include "common/options/help.hpp"

#include <fmt/format.h>

#include <sstream>

#include "common/options/spelling.hpp"
#include "gvd/option_text.hpp"

namespace gvd::app {
namespace {

constexpr std::size_t kHelpWidth = 80;
constexpr std::size_t kDescriptionColumn = 26;

/// Breaks names with a list of choices after bars, if they are longer than a line.
std::string break_at_bars(std::string title) {
  for (std::size_t begin = 0; title.size() - begin > kHelpWidth;) {
    const std::size_t bar = title.rfind('|', begin + kHelpWidth - 1);
    if (bar == title.npos || bar <= begin) break;
    title.insert(bar + 1, fmt::format("\n{:{}}", "", kDescriptionColumn));
    begin = bar + 2;
  }
  return title;
}

std::string make_line(const Option& option, const std::string& description) {
  const std::string value = option.spec.positional ? "" : value_name(option.field);
  const std::string title = fmt::format(
      "  {:{}}", fmt::format("{}{}{}", fmt::join(typed_names(option), ", "), value.empty() ? "" : " ", value),
      kDescriptionColumn - 4);
  const std::string gap =
      title.size() + 2 <= kDescriptionColumn ? "  " : fmt::format("\n{:{}}", "", kDescriptionColumn);
  return break_at_bars(title) + gap + wrap(description, kHelpWidth - kDescriptionColumn, kDescriptionColumn) + "\n";
}

std::string make_beginning(const CommandInfo& command) {
  return fmt::format("{}\n\nUsage: {} [OPTIONS] INPUT...\n", wrap(command.description, kHelpWidth, 0), command.name);
}

}  // namespace

std::string help_footer(const std::string& examples) {
  return "\nExamples:\n" + examples +
         "\nExit codes: 0 done, 2 usage, 3 unreadable input, 4 input breaks a precondition,\n"
         "5 no valid result or out of memory, 6 output could not be written,\n"
         "130 interrupted; with several inputs, the code of the first one that failed.\n";
}

std::string describe_in_full(const OptionList& list, const Option& option) {
  const Spec& spec = option.spec;
  std::string text = spec.help;
  if (!spec.unit.empty()) text += ", in " + spec.unit;
  text += spec.more;
  if (!spec.usual.empty()) text += fmt::format(" (default: {})", spec.usual);
  return spell(list, text);
}

std::string make_help(const CommandInfo& command, const OptionList& list) {
  std::string text = make_beginning(command);
  for (const std::string& group : list.groups()) {
    text += fmt::format("\n{}:\n", spell(list, group));
    for (const Option* const option : list.options()) {
      if (option->group == group && option->spec.shown != Shown::hidden) {
        text += make_line(*option, describe_in_full(list, *option));
      }
    }
  }
  return text + help_footer(command.examples);
}

std::string make_short_help(const CommandInfo& command, const OptionList& list) {
  std::string text = make_beginning(command) + "\n";
  for (const Option* const option : list.options()) {
    if (option->spec.shown == Shown::main) text += make_line(*option, spell(list, option->spec.help));
  }
  return text + fmt::format("\nAll options, and examples: {} --help\n", command.name);
}

std::string wrap(const std::string& text, std::size_t width, std::size_t indent) {
  std::istringstream words(text);
  std::string wrapped;
  std::size_t column = 0;
  for (std::string word; words >> word; column += word.size()) {
    if (column > 0 && column + 1 + word.size() > width) {
      wrapped += fmt::format("\n{:{}}", "", indent);
      column = 0;
    } else if (column > 0) {
      wrapped += ' ';
      ++column;
    }
    wrapped += word;
  }
  return wrapped;
}

}  // namespace gvd::app
