#include "common/options/command_line.hpp"

#include <CLI/CLI.hpp>

#include "gvd/error.hpp"

namespace gvd::app {
namespace {

bool is_positional(const OptionText& option) { return option.names.front() != '-'; }

}  // namespace

struct CommandLine::Parser {
  Parser(const std::string& name, const std::string& description) : cli(description, name) {}

  void describe(CLI::Option& added, const OptionText& option) {
    if (!option.group.empty()) added.group(option.group);
    if (!option.needs.empty()) added.needs(cli.get_option(option.needs));
    added.required(is_positional(option));
  }

  CLI::App cli;
};

CommandLine::CommandLine(const std::string& name, const std::string& description, const std::string& version,
                         const std::string& footer)
    : parser_(std::make_unique<Parser>(name, description)) {
  parser_->cli.set_help_flag("-h,--help", "Show this help");
  parser_->cli.set_version_flag("--version", version, "Show the version");
  parser_->cli.footer(footer);
}

CommandLine::~CommandLine() = default;

void CommandLine::add_value(const OptionText& option, const StoreValue& store) {
  const auto checked = [store, names = option.names](const std::string& text) {
    if (const auto wrong = store(text)) throw CLI::ValidationError(names, *wrong);
  };
  CLI::Option* const added = parser_->cli.add_option_function<std::string>(option.names, checked, option.description);
  added->type_name(option.type);
  parser_->describe(*added, option);
}

void CommandLine::add_list(const OptionText& option, const StoreList& store) {
  CLI::Option* const added =
      parser_->cli.add_option_function<std::vector<std::string>>(option.names, store, option.description);
  added->type_name(option.type)->allow_extra_args(false);
  parser_->describe(*added, option);
}

void CommandLine::add_flag(const OptionText& option, bool& target) {
  parser_->describe(*parser_->cli.add_flag(option.names, target, option.description), option);
}

void CommandLine::add_config(const OptionText& option) {
  parser_->cli.set_config(option.names, "", option.description)->type_name(option.type);
  parser_->cli.allow_config_extras(CLI::config_extras_mode::error);
}

std::optional<std::string> CommandLine::parse(int argc, const char* const* argv) {
  try {
    parser_->cli.parse(argc, argv);
    return std::nullopt;
  } catch (const CLI::CallForVersion& version) {
    return std::string(version.what()) + "\n";
  } catch (const CLI::Success&) {
    return parser_->cli.help();
  } catch (const CLI::Error& error) {
    throw Error(ErrorCode::invalid_option, std::string(error.what()) + " (see " + parser_->cli.get_name() + " --help)");
  }
}

}  // namespace gvd::app
