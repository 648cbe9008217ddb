// Reads the words of a command line into the fields of the options: decides which words belong to which option, which
// options of the file remain beside them, and which options go together.
//
// A value may begin with a dash (--up -z), but may not be the name of an option: in "--stats -o" a value is missing.
// Errors come in the order in which a user can correct them: first unknown names, then values, then options that
// exclude each other.

#include "common/options/command_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "common/options/completion.hpp"
#include "common/options/config_file.hpp"
#include "common/options/option_json.hpp"
#include "common/options/options.hpp"
#include "common/options/spelling.hpp"
#include "gvd/error.hpp"
#include "gvd/option_text.hpp"
#include "gvd/text.hpp"
#include "gvd/version.hpp"

namespace gvd::app {
namespace {

/// The option that a user calls by this name; null if there is none.
const Option* find_typed(const OptionList& list, const std::string& name) {
  for (const Option* const option : list.options()) {
    const std::vector<std::string> names = typed_names(*option);
    if (!option->spec.positional && std::find(names.begin(), names.end(), name) != names.end()) return option;
  }
  return nullptr;
}

/// Assigns the words of a command line to options.
class SplitWords {
 public:
  SplitWords(const OptionList& list, const std::vector<std::string>& words) : list_(list), words_(words) {
    for (next_ = 0; next_ < words_.size();) {
      const std::string& word = words_[next_++];
      const bool is_name = word.size() > 1 && word.front() == '-' && !parse_number<double>(word);
      if (word == "--") {
        for (; next_ < words_.size(); ++next_) add_input(words_[next_]);
      } else if (!is_name) {
        add_input(word);
      } else if (word.starts_with("--")) {
        read_long(word);
      } else {
        read_short(word);
      }
    }
  }

  std::vector<GivenTexts> given;
  std::vector<std::string> unknown;  ///< words that look like options

 private:
  void add_input(const std::string& word) {
    for (const Option* const option : list_.options()) {
      if (option->spec.positional) return add(*option, usual_name(*option), {word});
    }
    unknown.push_back(word);
  }

  /// Reads --name or --name=value.
  void read_long(const std::string& word) {
    const std::size_t equals = word.find('=');
    const Option* const option = find_typed(list_, word.substr(0, equals));
    if (option == nullptr) return unknown.push_back(word);
    if (equals != word.npos) return add(*option, word.substr(0, equals), {word.substr(equals + 1)});
    add(*option, word, take_values(*option));
  }

  /// Reads -n, -n5, or several flags that may end in an option with a value, such as -qn5.
  void read_short(const std::string& word) {
    for (std::size_t i = 1; i < word.size(); ++i) {
      const std::string name = {'-', word[i]};
      const Option* const option = find_typed(list_, name);
      if (option == nullptr) return unknown.push_back(word);
      if (!takes_value(option->field)) {
        add(*option, name, {});
        continue;
      }
      return add(*option, name, i + 1 < word.size() ? std::vector{word.substr(i + 1)} : take_values(*option));
    }
  }

  /// Takes the value after the name of an option, if there is one. After a name that may stand alone, only takes a word
  /// that is certainly its value: a number, or a word that can't be the INPUT.
  std::vector<std::string> take_values(const Option& option) {
    if (!takes_value(option.field) || next_ == words_.size()) return {};
    const std::string& word = words_[next_];
    if (find_typed(list_, word.substr(0, word.find('='))) != nullptr) return {};
    if (stands_alone(option.field)) {
      const bool is_number = std::holds_alternative<Number>(option.field);
      const bool has_input =
          std::any_of(given.begin(), given.end(), [](const auto& g) { return g.option->spec.positional; });
      const bool is_free = (word == "-" || !word.starts_with('-')) && (has_input || next_ + 1 < words_.size());
      if (is_number ? !parse_number<double>(word) : !is_free) return {};
    }
    ++next_;
    return {word};
  }

  void add(const Option& option, const std::string& name, std::vector<std::string> texts) {
    if (option.is_on) {  // --no-refine, --no-refine=true
      const auto value = parse_flag(texts.empty() ? "true" : texts.back());
      if (value) texts = {*value ? "false" : "true"};
    }
    const auto found = std::find_if(given.begin(), given.end(), [&](const auto& g) { return g.option == &option; });
    const bool takes = takes_value(option.field);
    // A missing or invalid value is reported even if the option is given again.
    const bool lacks = found != given.end() && takes && (texts.empty() || found->texts.empty());
    if (found == given.end() || lacks) return given.push_back({&option, {name, ""}, std::move(texts)});
    if (!takes && !found->texts.empty() && !parse_flag(found->texts.back())) return;
    if (!takes) found->texts.clear();  // the last value counts
    found->texts.insert(found->texts.end(), texts.begin(), texts.end());
  }

  const OptionList& list_;
  const std::vector<std::string>& words_;
  std::size_t next_ = 0;
};

/// Refuses unknown options in the order typed, each with a suggestion. The word after an unknown option may be its
/// value or an INPUT.
void check_known(const OptionList& list, const std::vector<std::string>& unknown, const std::string& hint) {
  if (unknown.empty()) return;
  std::vector<std::string> names;
  for (const Option* const option : list.options()) {
    for (const std::string& name : typed_names(*option)) names.push_back(name);
  }
  std::vector<std::string> described;
  for (const std::string& word : unknown) {
    const auto meant = suggest_name(word, names);
    const bool means_size = (word == "--faces" || word.starts_with("--faces=")) && list.find("target_edge") != nullptr;
    const char* const form = means_size ? "{} (-n sets the vertices; a closed mesh has about twice as many faces)"
                             : !meant   ? "{}"
                             : meant->front() == '-' ? "{} (did you mean {}?)"
                                                     : "{} ({} needs no option in front)";
    described.push_back(fmt::format(fmt::runtime(form), user_text(word), meant.value_or("")));
  }
  throw Error(ErrorCode::invalid_option,
              fmt::format("unknown option{}: {}{}", unknown.size() > 1 ? "s" : "", fmt::join(described, ", "), hint));
}

/// Reads the texts given for an option into its field.
void store(const OptionList& list, Given& given, const GivenTexts& texts, const std::string& hint) {
  given.add(texts.option->name, texts.source);
  if (texts.source.spelling == "-o" && !texts.texts.empty() && texts.texts.front().starts_with('=')) {
    // "=" separates a name with two dashes from its value, but "-o=a.ply" has the value "=a.ply".
    refuse_option(
        list, given,
        {texts.option->name, fmt::format("-o: '{}' begins with =; write -o {}", user_text(texts.texts.front()),
                                         user_text(texts.texts.front().substr(1)))},
        hint);
  }
  const std::string wrong = read_option(*texts.option, texts.texts);
  if (!wrong.empty())
    refuse_option(list, given, {texts.option->name, fmt::format("{}: {}", texts.source.spelling, wrong)}, hint);
  if (turns_off(texts)) given.remove(texts.option->name);
}

/// Answers the first question of a command line, such as --help.
std::optional<std::string> answer(const CommandInfo& command, const OptionList& list,
                                  const std::vector<GivenTexts>& typed, const std::string& hint) {
  for (const GivenTexts& question : typed) {
    const std::string& name = question.option->name;
    if (name == "h") return make_short_help(command, list);
    if (name == "help") return make_help(command, list);
    if (name == "version") return fmt::format("{} {}\n", command.name, version());
    if (name == "print_options") return print_description(list);
    if (name != "print_completion") continue;
    Given given;
    store(list, given, question, hint);
    return make_completion(command.name, list, question.texts.front()) + "\n";
  }
  return std::nullopt;
}

/// Reads the options of the file that the command line does not override.
std::vector<GivenTexts> read_file(const OptionList& list, const std::string& path,
                                  const std::vector<GivenTexts>& typed) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    throw Error(ErrorCode::invalid_option,
                fmt::format("--config {}: is a directory; name a TOML file of options", user_text(path)));
  }
  std::ifstream input(path);
  if (!input) {
    throw Error(ErrorCode::invalid_option, fmt::format("--config {}: there is no such file that can be read; name a "
                                                       "TOML file of options",
                                                       user_text(path)));
  }
  std::vector<GivenTexts> kept = read_config_file(list, input, path);
  std::erase_if(kept, [&](const GivenTexts& given) { return is_overridden(list, *given.option, typed); });
  return kept;
}

/// Drops options of the file that have no effect together with values of the command line.
void leave_out_idle(const OptionList& list, Given& given) {
  const auto is_typed = [&](const std::string& name) {
    const Given::Source* const source = given.find(name);
    return source != nullptr && source->place.empty();
  };
  for (const ValueRule& rule : list.rules()) {
    const bool is_overridden = std::any_of(rule.depends_on.begin(), rule.depends_on.end(), is_typed);
    if (!is_overridden || !given.has(rule.option) || is_typed(rule.option) || rule.why_idle(given).empty()) continue;
    list.find(rule.option)->reset();
    given.remove(rule.option);
  }
}

}  // namespace

void describe(OptionList& list, GeneralOptions& options) {
  list.group("General");
  list.option("h", Flag{&options.short_help},
              {.help = "Show the main options", .short_name = "h", .shown = Shown::answered});
  list.option("help", Flag{&options.help}, {.help = "Show all options", .shown = Shown::answered});
  list.option("version", Flag{&options.version}, {.help = "Show the version", .shown = Shown::answered});
  list.option("print_completion", choice(options.completion, kShells),
              {.help = "Print the script that completes this command in a shell", .shown = Shown::hidden});
  list.option("print_options", Flag{&options.description},
              {.help = "Print what --help says as JSON, and the formats of files", .shown = Shown::hidden});
  list.option("config", File{&options.config, File::Use::read, {"toml"}},
              {.help = "Read options from this TOML file", .more = "; the command line overrides it"});
  list.option("quiet", Flag{&options.quiet}, {.help = "Print errors only", .short_name = "q"});
  list.option("verbose", Flag{&options.verbose},
              {.help = "Print details and the time of each step", .short_name = "v"});
  list.excludes("quiet", {"verbose"});
}

std::optional<std::string> parse_command_line(const CommandInfo& command, const OptionList& list, Given& given,
                                              const std::vector<std::string>& words) {
  const std::string hint = fmt::format(" (see {} --help)", command.name);
  const SplitWords split(list, words);
  if (auto text = answer(command, list, split.given, hint)) return text;
  check_known(list, split.unknown, hint);
  for (const GivenTexts& texts : split.given) store(list, given, texts, hint);
  if (given.has("config")) {
    const std::string path = write_option(list.find("config")->field)->front();
    for (const GivenTexts& texts : read_file(list, path, split.given)) store(list, given, texts, hint);
  }
  for (const Option* const option : list.options()) {
    if (option->spec.required && !given.has(option->name)) {
      throw Error(ErrorCode::invalid_option, usual_name(*option) + " is required" + hint);
    }
  }
  leave_out_idle(list, given);
  if (const auto problem = list.find_problem(given)) refuse_option(list, given, *problem);
  return std::nullopt;
}

}  // namespace gvd::app
