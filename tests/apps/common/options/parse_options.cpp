#include "apps/common/options/parse_options.hpp"

#include "common/options/register_options.hpp"

namespace gvd::test {

std::optional<std::string> parse_line(app::CommandLine& line, const std::vector<std::string>& arguments) {
  std::vector<const char*> argv{"gvd-test"};
  for (const std::string& argument : arguments) argv.push_back(argument.c_str());
  return line.parse(static_cast<int>(argv.size()), argv.data());
}

app::Options parse_options(const std::vector<std::string>& arguments) {
  app::CommandLine line("gvd-test", "A test.", "gvd-test 1", "");
  app::Options options;
  app::register_options(line, options, kFormats);
  parse_line(line, arguments);
  return options;
}

}  // namespace gvd::test
