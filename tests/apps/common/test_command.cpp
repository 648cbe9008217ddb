#include <csignal>

#include "apps/common/options/parse_options.hpp"
#include "common/command.hpp"
#include "common/options/shared_options.hpp"
#include "gvd/diagram_options.hpp"
#include "gvd/error.hpp"
#include "support/catch.hpp"

namespace gvd::test_command {

using namespace app;
using gvd::test::kFormats;
using gvd::test::SharedOptions;

int run(
    std::vector<std::string> arguments, const std::function<void(Run&)>& body = [](Run&) {}) {
  static std::function<void(Run&)> current;  // steps are plain functions
  current = body;
  const CommandSteps<SharedOptions> steps{[](OptionList& list, SharedOptions& options) {
                                            describe_input(list, options.input);
                                            describe(list, options.generators);
                                            describe(list, options.diagram);
                                            describe_resources(list, options.compute);
                                            describe_output(list, options.output, kFormats, "ply");
                                          },
                                          [](Run& run, SharedOptions&) { current(run); }};
  arguments.insert(arguments.begin(), "gvd-test");
  std::vector<const char*> argv;
  for (const std::string& argument : arguments) argv.push_back(argument.c_str());
  const Command command =
      make_command<SharedOptions>({"gvd-test", "A test.", "  gvd-test a.obj -n 3", {kFormats}}, steps);
  return run_command(command, static_cast<int>(argv.size()), argv.data());
}

TEST_CASE("usage errors exit with 2") {
  const std::vector<std::vector<std::string>> wrong{
      {},
      {"a.obj"},
      {"-n", "3"},
      {"-", "-n", "3"},
      {"a.obj", "-n"},
      {"a.obj", "-n", "0"},
      {"a.obj", "-n", "3.5"},
      {"a.obj", "-n", "99999999999"},
      {"a.obj", "-n", "3", "--seed", "-1"},
      {"a.obj", "-n", "3", "--vertices", "1"},
      {"a.obj", "-n", "3", "--radius", "1"},
      {"a.obj", "--radius", "0"},
      {"a.obj", "--radius", "nan"},
      {"a.obj", "--radius", "inf"},
      {"a.obj", "--radius", "1,5"},
      {"a.obj", "--vertices", ""},
      {"a.obj", "--vertices", "1,,2"},
      {"a.obj", "--vertices", "1,-2"},
      {"a.obj", "--vertices", "1,x"},
      {"a.obj", "--sampling", "vertices", "--radius", "1"},
      {"a.obj", "-n", "3", "--max-snap", "1"},
      {"a.obj", "-n", "3", "--sampling", "best"},
      {"a.obj", "-n", "3", "--method", "other"},
      {"a.obj", "-n", "3", "--front", "planar"},
      {"a.obj", "-n", "3", "--method", "exact", "--front", "circle"},
      {"a.obj", "-n", "3", "--method", "gbgvd", "--front", "square"},
      {"a.obj", "-n", "3", "--method", "gbgvd", "--chord-tolerance", "1e-3"},
      {"a.obj", "-n", "3", "--chord-tolerance", "0"},
      {"a.obj", "-n", "3", "--chord-tolerance", "-1"},
      {"a.obj", "-n", "3", "--chord-tolerance", "9e-11"},
      {"a.obj", "-n", "3", "--chord-tolerance", "nan"},
      {"a.obj", "-n", "3", "--threads", "0"},
      {"a.obj", "-n", "3", "--on-defect", "maybe"},
      {"a.obj", "-n", "3", "-o", "a.doc"},
      {"a.obj", "-n", "3", "-o", "a"},
      {"a.obj", "-n", "3", "-o", "a.ply", "-o", "a.ply"},
      {"a.obj", "-n", "3", "-o", "a.json", "--report", "./a.json"},
      {"a.obj", "-n", "3", "--report", "-"},
      {"a.obj", "-n", "3", "--nonsense"},
      {"a.obj", "b.obj", "-n", "3"},
      {"a.obj", "-n", "3", "--config", "/nonexistent.toml"},
  };
  for (const auto& arguments : wrong) {
    CAPTURE(arguments);
    CHECK(run(arguments) == 2);
  }
}

TEST_CASE("a target that can't be written is refused before the work") {
  CHECK(run({"a.obj", "-n", "3", "-o", "/nonexistent/a.ply"}) == 6);
  CHECK(run({"a.obj", "-n", "3", "--report", "/tmp"}) == 6);
}

TEST_CASE("each error has its exit code") {
  const auto code_of = [](ErrorCode code) {
    return run({"a.obj", "-n", "3"}, [code](Run&) { throw Error(code, "said on purpose\nby a test"); });
  };
  CHECK(code_of(ErrorCode::invalid_option) == 2);
  CHECK(code_of(ErrorCode::unreadable_input) == 3);
  CHECK(code_of(ErrorCode::precondition) == 4);
  CHECK(code_of(ErrorCode::no_valid_result) == 5);
  CHECK(code_of(ErrorCode::unwritable_output) == 6);
  CHECK(code_of(ErrorCode::interrupted) == 130);
  CHECK(run({"a.obj", "-n", "3"}, [](Run&) { throw std::bad_alloc(); }) == 5);
  CHECK(run({"a.obj", "-n", "3"}) == 0);
}

TEST_CASE("a signal cancels the work at the next step or progress call, with exit code 130") {
  const std::vector<std::string> arguments{"a.obj", "-n", "3"};
  CHECK(run(arguments, [](Run& run) {
          std::raise(SIGINT);
          report_progress(run.progress(), "work", 0.5);
          FAIL("went on");
        }) == 130);
  CHECK(run(arguments, [](Run& run) {
          std::raise(SIGTERM);
          run.timed("step", [] { FAIL("went on"); });
        }) == 130);
  CHECK(run(arguments, [](Run& run) {
          report_progress(run.progress(), "work", 0.5);
          CHECK(run.timed("step", [] { return 3; }) == 3);
        }) == 0);
}

}  // namespace gvd::test_command
