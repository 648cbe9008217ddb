#include "apps/common/options/parse_options.hpp"

#include "common/options/command_line.hpp"
#include "common/options/shared_options.hpp"
#include "common/options/spelling.hpp"
#include "common/outcome.hpp"
#include "gvd/diagram_options.hpp"
#include "gvd/error.hpp"

namespace gvd::test {

SharedLine::SharedLine() {
  app::describe_input(list, options.input);
  describe(list, options.generators);
  app::describe_generators_format(list, options.input);
  describe(list, options.diagram);
  app::describe_resources(list, options.compute);
  app::describe_verify(list, options.compute);
  app::describe_output(list, options.output, kFormats, "ply");
  app::describe_no_curves(list, options.output);
  app::describe_diagram_output(list, options.output);
  app::describe(list, options.general);
}

std::optional<std::string> SharedLine::parse(const std::vector<std::string>& arguments) {
  auto answer = app::parse_command_line({"gvd-test", "A test.", "  gvd-test a.obj\n"}, list, given, arguments);
  if (!options.input.paths.empty()) options.input.path = options.input.paths.front();
  return answer;
}

SharedOptions parse_options(const std::vector<std::string>& arguments) {
  SharedLine line;
  line.parse(arguments);
  return line.options;
}

void check_line(const std::vector<std::string>& arguments, const app::OutputFormats& formats) {
  SharedLine line;
  check_line(line, arguments, formats);
}

void check_line(SharedLine& line, const std::vector<std::string>& arguments, const app::OutputFormats& formats) {
  line.parse(arguments);
  line.options.list = &line.list;
  line.options.given = &line.given;
  try {
    app::check_inputs(line.options, formats);
    if (const auto missing = line.list.find_missing(line.given)) app::refuse_option(line.list, line.given, *missing);
    app::check_outputs(line.options, formats);
  } catch (const Error& error) {  // in the words of a command
    throw Error(error.code(), app::run_guarded([&] { throw error; }, &line.options).message);
  }
}

}  // namespace gvd::test
