#include "apps/common/options/parse_options.hpp"

#include "common/options/register_options.hpp"

namespace gvd::test {

std::optional<std::string> parse_line(CLI::App& app, const std::vector<std::string>& arguments,
                                      const std::vector<app::ValueRule>& rules) {
  std::vector<const char*> argv{"gvd-test"};
  for (const std::string& argument : arguments) argv.push_back(argument.c_str());
  return app::parse_command_line(app, rules, static_cast<int>(argv.size()), argv.data());
}

app::Options parse_options(const std::vector<std::string>& arguments) {
  CLI::App line("A test.", "gvd-test");
  app::Options options;
  const std::vector<app::ValueRule> rules = app::register_options(line, options, kFormats);
  app::register_general(line, options, "gvd-test 1");
  parse_line(line, arguments, rules);
  return options;
}

}  // namespace gvd::test
