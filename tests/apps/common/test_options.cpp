#include <csignal>
#include <filesystem>
#include <fstream>

#include "common/command.hpp"
#include "common/register_options.hpp"
#include "gvd/error.hpp"
#include "support/catch.hpp"

using namespace gvd;
using namespace gvd::app;

namespace {

const std::vector<std::string> kFormats{"ply", "obj", "json"};

Options parse(std::vector<std::string> arguments) {
  CLI::App cli("test", "test");
  Options options;
  register_options(cli, options, kFormats);
  std::reverse(arguments.begin(), arguments.end());
  cli.parse(arguments);
  check_options(options, kFormats);
  return options;
}

int run(
    std::vector<std::string> arguments, const std::function<void(Run&)>& body = [](Run&) {}) {
  Command command({"gvd-test", "A test.", "  gvd-test a.obj -n 3", kFormats});
  arguments.insert(arguments.begin(), "gvd-test");
  std::vector<const char*> argv;
  for (const std::string& argument : arguments) argv.push_back(argument.c_str());
  return command.run(static_cast<int>(argv.size()), argv.data(), body);
}

}  // namespace

TEST_CASE("the defaults are the contract's") {
  const Options options = parse({"a.obj", "-n", "30"});
  CHECK(options.input.path == "a.obj");
  CHECK(options.input.on_defect == "repair");
  CHECK(options.generators.count == 30);
  CHECK(options.generators.sampling == SamplingKind::farthest);
  CHECK(options.generators.seed == 0);
  CHECK(options.compute.method == Method::exact);
  CHECK_FALSE(options.compute.front);
  const DiagramOptions diagram = make_diagram_options(options.compute);
  CHECK(diagram.method == Method::exact);
  CHECK(diagram.chord_tolerance == 1e-4);
  CHECK(options.output.stdout_format == "ply");
}

TEST_CASE("every option reaches its place") {
  const Options options = parse({"-",
                                 "--input-format",
                                 "off",
                                 "--on-defect",
                                 "largest",
                                 "-n",
                                 "010",
                                 "--sampling",
                                 "poisson",
                                 "--seed",
                                 "18446744073709551615",
                                 "--method",
                                 "gbgvd",
                                 "--front",
                                 "planar",
                                 "--threads",
                                 "2",
                                 "--verify",
                                 "-o",
                                 "a.ply",
                                 "-o",
                                 "B.OBJ",
                                 "-o",
                                 "-",
                                 "--output-format",
                                 "json",
                                 "--report",
                                 "r.json",
                                 "--diagram",
                                 "d.json",
                                 "--view",
                                 "v.html",
                                 "-q",
                                 "-v",
                                 "--merge-coincident"});
  CHECK(options.input.format == "off");
  CHECK(options.input.on_defect == "largest");
  CHECK(options.generators.count == 10);
  CHECK(options.generators.sampling == SamplingKind::poisson);
  CHECK(options.generators.seed == 18446744073709551615u);
  CHECK(options.generators.merge_coincident);
  CHECK(options.compute.method == Method::gbgvd);
  CHECK(options.compute.front == Front::planar);
  CHECK(make_diagram_options(options.compute).front == Front::planar);
  CHECK(options.compute.threads == 2);
  CHECK(options.compute.verify);
  CHECK(options.output.files == std::vector<std::string>{"a.ply", "B.OBJ", "-"});
  CHECK(options.output.stdout_format == "json");
  CHECK(options.output.view == "v.html");
  CHECK(options.quiet);
  CHECK(parse({"--vertices", "3, 17,99", "a.obj"}).generators.vertices == std::vector<std::int64_t>{3, 17, 99});
  CHECK(parse({"a.obj", "-n", "3", "--chord-tolerance", "2.5e-7"}).compute.chord_tolerance == 2.5e-7);
  CHECK(parse({"a.obj", "--radius", "2.5e-1"}).generators.radius == 0.25);
  CHECK(parse({"a.obj", "--generators", "g.txt", "--max-snap", "0"}).generators.max_snap == 0.0);
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
      {"a.obj", "--sampling", "poisson", "--radius", "1"},
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

TEST_CASE("a signal cancels the work at the next step or progress") {
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
          run.timed("step", [] {});
          CHECK(run.report().timings_ms.size() == 1);
        }) == 0);
}

TEST_CASE("a configuration file gives options, and the command line goes before it") {
  const auto path = std::filesystem::temp_directory_path() / "gvd_test_options.toml";
  const auto with = [&](const std::string& text, std::vector<std::string> arguments) {
    std::ofstream(path) << text;
    arguments.insert(arguments.end(), {"--config", path.string()});
    return parse(arguments);
  };
  const Options options = with(
      "# a comment\nn = 12\nseed = 7\nmethod = \"gbgvd\"\nfront = \"planar\"\nverify = true\n"
      "output = [\"a.ply\", \"b.obj\"]\n",
      {"a.obj", "--seed", "9"});
  CHECK(options.generators.count == 12);
  CHECK(options.generators.seed == 9);
  CHECK(options.compute.front == Front::planar);
  CHECK(options.compute.verify);
  CHECK(options.output.files == std::vector<std::string>{"a.ply", "b.obj"});
  CHECK(with("vertices = \"1,2\"\n", {"a.obj"}).generators.vertices == std::vector<std::int64_t>{1, 2});
  CHECK(with("vertices = [1, 2]\n", {"a.obj"}).generators.vertices == std::vector<std::int64_t>{1, 2});
  CHECK_THROWS_AS(with("nonsense = 3\n", {"a.obj", "-n", "3"}), CLI::ConfigError);
  CHECK_THROWS_AS(with("seed = minus\n", {"a.obj", "-n", "3"}), CLI::ValidationError);
  std::filesystem::remove(path);
}
