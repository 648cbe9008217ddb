#include "common/options/command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <deque>
#include <utility>

#include "common/options/config_options.hpp"
#include "common/options/help_text.hpp"
#include "common/options/merge_options.hpp"
#include "common/options/suggest_name.hpp"
#include "gvd/error.hpp"

namespace gvd::app {
namespace {

bool is_positional(const OptionText& option) { return option.names.front() != '-'; }

/// The value of a flag, for GivenOption.
std::string flag_text(bool on) { return on ? "true" : "false"; }

/// Adds what a message of a store function lacks: where the option comes from.
[[noreturn]] void refuse(const GivenOption& given, const std::string& message) {
  throw Error(ErrorCode::invalid_option, given.place.empty() ? message : given.place + ": " + message);
}

void store(const GivenOption& given, const std::string& hint) {
  std::optional<std::string> wrong;
  try {
    wrong = given.option->store(given.values);
  } catch (const Error& error) {
    refuse(given, error.what());
  }
  if (wrong) refuse(given, given.name + ": " + *wrong + (given.place.empty() ? hint : ""));
}

/// See OptionText::idle.
void check_idle(const GivenOption& given, const std::vector<GivenOption>& line) {
  const OptionText& text = given.option->text;
  if (!text.idle || !is_given_as(given, split_names(text.names).front())) return;
  const std::optional<std::string> reason = text.idle();
  if (!reason) return;
  const bool overridden = std::any_of(line.begin(), line.end(), [&](const GivenOption& other) {
    return std::any_of(text.depends_on.begin(), text.depends_on.end(),
                       [&](const std::string& name) { return is_given_as(other, name); });
  });
  if (given.place.empty() || !overridden) refuse(given, fmt::format("{}: {}", given.name, *reason));
  given.option->store({flag_text(false)});
}

}  // namespace

struct CommandLine::Parser {
  /// An option of the command, and how CLI11 gives its values.
  struct Entry {
    CLI::Option* option;
    std::vector<std::string> values;
    bool flag = false;
  };

  Parser(const std::string& name, const std::string& description) : cli(description, name) {}

  DeclaredOption& declare(const OptionText& text) {
    shown.push_back(text);
    declared.push_back({text, false, {}});
    entries.emplace_back();
    return declared.back();
  }

  std::vector<GivenOption> given_on_line() const {
    std::vector<GivenOption> given;
    for (std::size_t i = 0; i < entries.size(); ++i) {
      if (entries[i].option->count() == 0) continue;
      const std::string name = split_names(declared[i].text.names).front();
      check_equals_sign(name, entries[i].values);
      const bool flag = declared[i].text.kind == ValueKind::flag;
      given.push_back({&declared[i], name, "", flag ? std::vector{flag_text(entries[i].flag)} : entries[i].values});
    }
    return given;
  }

  void check_required(const std::vector<GivenOption>& given) const {
    for (const DeclaredOption& option : declared) {
      if (!is_positional(option.text)) continue;
      const bool found =
          std::any_of(given.begin(), given.end(), [&](const auto& one) { return one.option == &option; });
      if (!found) throw CLI::RequiredError(option.text.names);
    }
  }

  std::string help() const {
    return fmt::format("{}\n\nUsage: {} {} [options]\n{}{}", wrap(cli.get_description(), kHelpWidth, 0), cli.get_name(),
                       fmt::join(positionals(), " "), describe_options(shown), cli.get_footer());
  }

  std::vector<std::string> positionals() const {
    std::vector<std::string> names;
    for (const DeclaredOption& option : declared) {
      if (is_positional(option.text)) names.push_back(option.is_list ? option.text.names + "..." : option.text.names);
    }
    return names;
  }

  /// Refuses what CLI11 did not know, in the order typed, each with the name that it may stand for. What follows a
  /// wrong option may be its value, and is not told.
  void check_known() const {
    std::vector<std::string> names, unknown, unexpected;
    for (const OptionText& option : shown) {
      for (const std::string& name : split_names(option.names)) names.push_back(name);
    }
    bool is_marked = false;  // by "--", after which nothing is an option
    for (const std::string& word : cli.remaining()) {
      if (word == "--" && !std::exchange(is_marked, true)) continue;
      if (is_marked || word.size() < 2 || word.front() != '-') {
        unexpected.push_back(printable(word));
        continue;
      }
      unknown.push_back(printable(word) + hint_at(suggest_name(word, names)));
    }
    if (!unknown.empty()) {
      refuse_line(fmt::format("unknown option{}: {}", unknown.size() > 1 ? "s" : "", fmt::join(unknown, ", ")));
    }
    if (!unexpected.empty()) refuse_line(fmt::format("unexpected: {}", fmt::join(unexpected, ", ")));
  }

  /// "=" parts a name with two dashes from its value, but "-n=3" is the value "=3".
  void check_equals_sign(const std::string& name, const std::vector<std::string>& values) const {
    if (name.starts_with("--") || name.front() != '-') return;
    for (const std::string& value : values) {
      if (!value.starts_with('=')) continue;
      refuse_line(
          fmt::format("{}: '{}' begins with =; write {} {}", name, printable(value), name, printable(value.substr(1))));
    }
  }

  /// What CLI11 found wrong, in our words.
  std::string describe(const CLI::Error& error) const {
    const std::string message = error.what(), name = message.substr(0, message.find(':'));
    constexpr std::string_view kConvert = "Could not convert: ";
    if (message.starts_with(kConvert)) return message.substr(kConvert.size()) + ": expected true or false";
    if (message.find(": At Most 1 ") != message.npos) return name + ": is there several times; keep one";
    if (!message.ends_with(" missing")) return message;
    const auto has_name = [&](const OptionText& option) {
      const std::vector<std::string> names = split_names(option.names);
      return std::find(names.begin(), names.end(), name) != names.end();
    };
    const auto option = std::find_if(shown.begin(), shown.end(), has_name);
    return fmt::format("{}: its value is missing; write {} {}", name, name, option == shown.end() ? "" : option->type);
  }

  static std::string hint_at(const std::optional<std::string>& meant) {
    if (!meant) return "";
    if (meant->front() != '-') return fmt::format(" ({} needs no option in front)", *meant);
    return fmt::format(" (did you mean {}?)", *meant);
  }

  [[noreturn]] void refuse_line(const std::string& message) const {
    throw Error(ErrorCode::invalid_option, fmt::format("{}{}", message, hint()));
  }

  std::string hint() const { return " (see " + cli.get_name() + " --help)"; }

  CLI::App cli;
  std::vector<OptionText> shown;  ///< by --help
  std::deque<DeclaredOption> declared;
  std::deque<Entry> entries;  ///< of the same indices
  std::optional<std::string> config;
};

CommandLine::CommandLine(const std::string& name, const std::string& description, const std::string& version,
                         const std::string& footer)
    : parser_(std::make_unique<Parser>(name, description)) {
  parser_->cli.set_help_flag("-h,--help");
  parser_->cli.set_version_flag("--version", version);
  parser_->cli.footer(footer);
  parser_->cli.allow_extras();
  parser_->shown = {{"-h,--help", "", "Show this help"}, {"--version", "", "Show the version"}};
}

CommandLine::~CommandLine() = default;

void CommandLine::add_value(const OptionText& option, const StoreValue& store) {
  parser_->declare(option).store = [store](const std::vector<std::string>& values) { return store(values.back()); };
  std::vector<std::string>& values = parser_->entries.back().values;
  const auto keep = [&values](const std::string& text) { values = {text}; };
  parser_->entries.back().option = parser_->cli.add_option_function<std::string>(option.names, keep);
}

void CommandLine::add_list(const OptionText& option, const StoreList& store) {
  DeclaredOption& declared = parser_->declare(option);
  declared.is_list = true;
  declared.store = [store](const std::vector<std::string>& values) {
    store(values);
    return std::optional<std::string>();
  };
  std::vector<std::string>& values = parser_->entries.back().values;
  const auto keep = [&values](const std::vector<std::string>& all) { values = all; };
  CLI::Option* const added = parser_->cli.add_option_function<std::vector<std::string>>(option.names, keep);
  if (!is_positional(option)) added->allow_extra_args(false);
  parser_->entries.back().option = added;
}

void CommandLine::add_flag(const OptionText& option, bool& target) {
  DeclaredOption& declared = parser_->declare(option);
  declared.text.kind = ValueKind::flag;
  declared.store = [&target](const std::vector<std::string>& values) {
    target = values.back() == flag_text(true);
    return std::optional<std::string>();
  };
  parser_->entries.back().option = parser_->cli.add_flag(option.names, parser_->entries.back().flag);
}

void CommandLine::add_config(const OptionText& option, std::string& target) {
  const auto keep = [this, &target](const std::string& path) { parser_->config = target = path; };
  parser_->cli.add_option_function<std::string>(option.names, keep);
  parser_->shown.push_back(option);
}

std::optional<std::string> CommandLine::parse(int argc, const char* const* argv) {
  try {
    parser_->config.reset();
    parser_->cli.parse(argc, argv);
    parser_->check_known();
    std::vector<GivenOption> given = parser_->given_on_line();
    const std::vector<GivenOption> line = given;
    if (parser_->config) {
      given = merge_options(given, find_config_options(read_config_file(*parser_->config), parser_->declared));
    }
    parser_->check_required(given);
    check_together(given);
    for (const GivenOption& each : given) store(each, parser_->hint());
    for (const GivenOption& each : given) check_idle(each, line);
    return std::nullopt;
  } catch (const CLI::CallForVersion& version) {
    return std::string(version.what()) + "\n";
  } catch (const CLI::Success&) {
    return parser_->help();
  } catch (const CLI::Error& error) {
    parser_->refuse_line(parser_->describe(error));
  }
}

}  // namespace gvd::app
