// From argv to the targets of the options, by CLI11. This adds what users meet around it: unknown names with the ones
// that they may stand for, a help in columns, errors of one line with their place in a file, and options that depend
// on values. Each error says what is wrong, where, and where the help is.

#include "common/options/command_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>

#include "common/options/config_file.hpp"
#include "common/options/options.hpp"
#include "common/options/typed_options.hpp"
#include "gvd/error.hpp"
#include "gvd/text.hpp"

namespace gvd::app {
namespace {

constexpr std::size_t kHelpWidth = 80;
constexpr std::size_t kDescriptionColumn = 26;

/// A shorter beginning fits too many options. Of what is no option, and written in capitals, there is one at most.
std::size_t least_beginning(const std::string& name) { return name.front() >= 'A' && name.front() <= 'Z' ? 1 : 3; }

/// "--Sampling=random" as "sampling".
std::string bare_name(const std::string& text) {
  const std::size_t first = text.find_first_not_of('-');
  return first == text.npos ? "" : to_lower(text.substr(first, text.find('=') - first));
}

/// Whether `typed` has the beginnings of words of `name`, in their order and with its first one, with or without the
/// dashes between them: "outdir" or "out-d" for "output-dir".
bool abbreviates(std::string_view typed, std::string_view name) {
  if (typed.empty()) return true;
  if (!name.empty() && typed.front() == name.front() && abbreviates(typed.substr(1), name.substr(1))) return true;
  const std::size_t dash = name.find('-');
  if (dash == name.npos || dash + 1 == name.size()) return false;
  const std::string_view next = name.substr(dash + 1), rest = typed.substr(typed.front() == '-' ? 1 : 0);
  return !rest.empty() && rest.front() == next.front() && abbreviates(rest.substr(1), next.substr(1));
}

/// Insertions, deletions, replacements and swaps of neighbours that lead from one text to the other: the distance of
/// Damerau and Levenshtein, with no letter changed twice.
std::size_t count_edits(const std::string& from, const std::string& to) {
  std::vector<std::size_t> before, last, now(to.size() + 1);
  for (std::size_t j = 0; j <= to.size(); ++j) now[j] = j;
  for (std::size_t i = 1; i <= from.size(); ++i) {
    before = std::move(last);
    last = now;
    now[0] = i;
    for (std::size_t j = 1; j <= to.size(); ++j) {
      now[j] = std::min({last[j] + 1, now[j - 1] + 1, last[j - 1] + (from[i - 1] != to[j - 1])});
      const bool swapped = i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1];
      if (swapped) now[j] = std::min(now[j], before[j - 2] + 1);
    }
  }
  return now[to.size()];
}

/// The options of -h, which fit a screen: where meshes and generators come from, what is asked for, and where results
/// go.
bool is_main(const CLI::Option& option) {
  constexpr std::array kMain{"INPUT",    "-n",           "--generators", "--from",  "--to",       "--target-edge",
                             "--error",  "--iterations", "--features",   "--paths", "--isolines", "--cut",
                             "--output", "--output-dir", "--report",     "--view",  "--stats",    "--points"};
  return std::any_of(kMain.begin(), kMain.end(), [&](const char* name) { return option.check_name(name); });
}

/// Every name that a user can type, and those of positional arguments.
std::vector<std::string> list_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* const option : app.get_options()) {
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    if (option->get_positional()) names.push_back(option->get_name(true));
  }
  return names;
}

/// Refuses what CLI11 did not know, in the order typed, each with the name that it may stand for. The word behind a
/// wrong option may be its value, or an INPUT.
void check_known(const CLI::App& app, const std::string& hint) {
  const std::vector<std::string> names = list_names(app);
  std::vector<std::string> unknown;
  for (const std::string& word : app.remaining()) {
    if (word == "--") continue;
    const auto meant = suggest_name(word, names);
    const bool means_size = bare_name(word) == "faces" && app.get_option_no_throw("--target-edge") != nullptr;
    const char* const form = means_size ? "{} (-n sets the vertices; a closed mesh has about twice as many faces)"
                             : !meant   ? "{}"
                             : meant->front() == '-' ? "{} (did you mean {}?)"
                                                     : "{} ({} needs no option in front)";
    unknown.push_back(fmt::format(fmt::runtime(form), printable(word), meant.value_or("")));
  }
  if (unknown.empty()) return;
  throw Error(ErrorCode::invalid_option,
              fmt::format("unknown option{}: {}{}", unknown.size() > 1 ? "s" : "", fmt::join(unknown, ", "), hint));
}

/// Joins --weld and the number behind it to one word, and gives it the number 0 where there is none: what follows may
/// be an INPUT.
std::vector<std::string> join_weld_number(const std::vector<std::string>& words) {
  std::vector<std::string> joined;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == "--") {
      joined.insert(joined.end(), words.begin() + std::ptrdiff_t(i), words.end());
      break;
    }
    joined.push_back(words[i]);
    if (words[i] != kWeldOption) continue;
    const bool has_number = i + 1 < words.size() && parse_number<double>(words[i + 1]);
    joined.back() += has_number ? "=" + words[++i] : "=0";
  }
  return joined;
}

void apply_rules(const std::vector<ValueRule>& rules, const ConfigFile& file) {
  const auto is_typed = [&](const CLI::Option* option) { return is_given(*option) && file.place_of(option).empty(); };
  const auto is_idle = [](const ValueRule& rule) { return is_given(*rule.option) && !rule.idle().empty(); };
  for (const ValueRule& rule : rules) {
    const bool is_overridden = std::any_of(rule.depends_on.begin(), rule.depends_on.end(), is_typed);
    if (is_overridden && !is_typed(rule.option) && is_idle(rule)) {
      rule.leave_out();
      rule.option->clear();
    }
  }
  for (const ValueRule& rule : rules) {
    const std::string place = file.place_of(rule.option);
    if (is_idle(rule)) throw Error(ErrorCode::invalid_option, place + (place.empty() ? "" : ": ") + rule.idle());
  }
}

/// Breaks names and a list of choices behind bars, where they are longer than a line.
std::string break_at_bars(std::string title) {
  for (std::size_t begin = 0; title.size() - begin > kHelpWidth;) {
    const std::size_t bar = title.rfind('|', begin + kHelpWidth - 1);
    if (bar == title.npos || bar <= begin) break;
    title.insert(bar + 1, fmt::format("\n{:{}}", "", kDescriptionColumn));
    begin = bar + 2;
  }
  return title;
}

}  // namespace

std::optional<std::string> suggest_name(const std::string& wrong, const std::vector<std::string>& names) {
  const std::string typed = bare_name(wrong);
  std::optional<std::string> nearest, longer;
  std::size_t least = std::max<std::size_t>(1, typed.size() / 3) + 1;
  for (const std::string& name : names) {
    const std::string bare = bare_name(name);
    // So many letters at least have to be inserted or deleted.
    const std::size_t fewest = std::max(typed.size(), bare.size()) - std::min(typed.size(), bare.size());
    const std::size_t edits = fewest < least ? count_edits(typed, bare) : least;
    // An option of one letter is nobody's misspelling.
    if (edits < least && (bare.size() > 1 || edits == 0)) {
      least = edits;
      nearest = name;
    }
    const bool begins = typed.size() >= least_beginning(name) && typed.size() <= bare.size() &&
                        typed.front() == bare.front() && abbreviates(typed, bare);
    if (begins && (!longer || name.size() < longer->size())) longer = name;
  }
  return longer && least > 0 ? longer : nearest;
}

std::string first_clause(const std::string& description) {
  std::size_t end = description.size();
  for (const char* detail : {";", " (default", ", or ", ", in "}) end = std::min(end, description.find(detail));
  return description.substr(0, end);
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

std::string HelpFormatter::make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const {
  std::string text = wrap(app->get_description(), kHelpWidth, 0) + "\n\n" + make_usage(app, name);
  if (mode == CLI::AppFormatMode::Normal) return text + make_main_options(app);
  for (const std::string& group : app->get_groups()) {
    if (group.empty()) continue;  // --print-completion
    text += fmt::format("\n{}:\n", group);
    for (const CLI::Option* const option : app->get_options()) {
      if (option->get_group() == group) text += make_option(option, option->get_positional());
    }
  }
  return text + app->get_footer();
}

std::string HelpFormatter::make_main_options(const CLI::App* app) const {
  std::string text = "\n";
  for (const CLI::Option* const option : app->get_options()) {
    if (is_main(*option)) text += make_line(option, first_clause(option->get_description()));
  }
  return text + fmt::format("\nAll options, and examples: {} --help\n", app->get_name());
}

std::string HelpFormatter::make_option(const CLI::Option* option, bool) const {
  return make_line(option, option->get_description());
}

std::string HelpFormatter::make_line(const CLI::Option* option, const std::string& description) {
  const bool is_positional = option->get_positional();
  const std::string type = option->get_items_expected_max() > 0 ? " " + option->get_type_name() : "";
  const std::string names = CLI::detail::find_and_replace(option->get_name(is_positional, true), ",", ", ");
  const std::string title = fmt::format("  {:{}}", names + type, kDescriptionColumn - 4);
  const std::string gap =
      title.size() + 2 <= kDescriptionColumn ? "  " : fmt::format("\n{:{}}", "", kDescriptionColumn);
  return break_at_bars(title) + gap + wrap(description, kHelpWidth - kDescriptionColumn, kDescriptionColumn) + "\n";
}

std::optional<std::string> parse_command_line(CLI::App& app, const std::vector<ValueRule>& rules, int argc,
                                              const char* const* argv) {
  const auto file = std::make_shared<ConfigFile>(app);
  app.config_formatter(file);
  app.formatter(std::make_shared<HelpFormatter>());
  app.allow_extras();
  const std::string hint = fmt::format(" (see {} --help)", app.get_name());
  try {
    const std::vector<std::string> words = join_weld_number({argv, argv + argc});
    std::vector<const char*> texts;
    for (const std::string& word : words) texts.push_back(word.c_str());
    app.parse(static_cast<int>(texts.size()), texts.data());
  } catch (const CLI::CallForVersion& version) {
    return std::string(version.what()) + "\n";
  } catch (const CLI::CallForAllHelp&) {
    return app.help("", CLI::AppFormatMode::All);
  } catch (const CLI::Success&) {
    return app.help();
  } catch (const CLI::Error& error) {
    check_known(app, hint);  // a misspelt name may be all that is wrong
    const std::string message = file->with_place(error.what());
    throw Error(ErrorCode::invalid_option, message == error.what() ? message + hint : message);
  }
  check_known(app, hint);
  apply_rules(rules, *file);
  return std::nullopt;
}

}  // namespace gvd::app
