#include "apps/common/options/parse_options.hpp"
#include "apps/run_command.hpp"
#include "common/options/shared_options.hpp"
#include "gvd/error.hpp"
#include "support/catch.hpp"

namespace gvd::test_shared_options {

using namespace app;
using gvd::test::parse_options;
using gvd::test::SharedLine;
using gvd::test::SharedOptions;

TEST_CASE("a value that is missing is told, also where the option is given again") {
  const auto told = [](const std::vector<std::string>& words) {
    try {
      parse_options(words);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  CHECK_THAT(told({"a.obj", "--count", "-n", "3"}), Catch::Matchers::Contains("value is missing"));
  CHECK_THAT(told({"a.obj", "-n", "3", "-o", "-o", "x.ply"}), Catch::Matchers::Contains("value is missing"));
  CHECK_THAT(told({"a.obj", "-n", "3", "--verify=bogus", "--verify=false"}), Catch::Matchers::Contains("bogus"));
}

TEST_CASE("every name in the rules and texts of the shared options is an option's") {
  SharedLine line;
  CHECK(line.list.find_unknown_names().empty());
}

TEST_CASE("the defaults are the contract's") {
  const SharedOptions options = parse_options({"a.obj", "-n", "30"});
  CHECK(options.input.path == "a.obj");
  CHECK(options.input.on_defect == DefectPolicy::repair);
  CHECK(options.generators.count == 30);
  CHECK(options.generators.sampling == Sampling::farthest);
  CHECK(options.generators.seed == 0);
  CHECK(options.diagram.method == Method::exact);
  CHECK_FALSE(options.diagram.front);
  CHECK(options.diagram.chord_tolerance == 1e-4);
  CHECK(format_of(options.output, "-") == "ply");
}

TEST_CASE("every option is stored in its field") {
  const SharedOptions options = parse_options({"-",
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
                                               "--up",
                                               "-x",
                                               "-q"});
  CHECK(options.input.format == MeshFormat::off);
  CHECK(options.input.on_defect == DefectPolicy::largest);
  CHECK(options.generators.count == 10);
  CHECK(options.generators.sampling == Sampling::poisson);
  CHECK(options.generators.seed == 18446744073709551615u);
  CHECK(options.diagram.method == Method::gbgvd);
  CHECK(options.diagram.front == Front::planar);
  CHECK(options.diagram.chosen_front() == Front::planar);
  CHECK(options.compute.threads == 2);
  CHECK(options.compute.verify);
  CHECK(options.output.files == std::vector<std::string>{"a.ply", "B.OBJ", "-"});
  CHECK(format_of(options.output, "-") == "json");
  CHECK(options.output.view == "v.html");
  CHECK(options.output.up == UpAxis::minus_x);
  CHECK(options.general.quiet);
  CHECK(parse_options({"a.obj", "-n", "3", "--view", "v.html", "--up=z"}).output.up == UpAxis::z);
  CHECK_FALSE(parse_options({"a.obj", "-n", "3", "--view", "v.html"}).output.up);
  CHECK_THROWS_AS(parse_options({"a.obj", "-n", "3", "--up", "z"}), Error);
  CHECK_THROWS_AS(parse_options({"a.obj", "-n", "3", "--view", "v.html", "--up", "w"}), Error);
  CHECK(parse_options({"--vertices", "3, 17,99", "a.obj"}).generators.vertices.vertices ==
        std::vector<std::int64_t>{3, 17, 99});
  CHECK(parse_options({"a.obj", "-n", "3", "--chord-tolerance", "2.5e-7"}).diagram.chord_tolerance == 2.5e-7);
  CHECK(parse_options({"a.obj", "--radius", "2.5e-1"}).generators.radius == 0.25);
  CHECK(parse_options({"a.obj", "--generators", "g.txt", "--max-snap", "0"}).generators.max_snap == 0.0);
  CHECK(parse_options({"a.obj", "--vertices", "3", "--merge-coincident"}).generators.merge_coincident);
  CHECK(parse_options({"a.obj", "-n", "3", "-v"}).general.verbose);
}

TEST_CASE("a configuration file gives options, and the command line goes before it") {
  const test::ScratchFolder scratch;
  const std::string path = scratch / "options.toml";
  const auto with = [&](const std::string& text, std::vector<std::string> arguments) {
    test::write_text(path, text);
    arguments.insert(arguments.end(), {"--config", path});
    return parse_options(arguments);
  };
  const SharedOptions options = with(
      "# a comment\nn = 12\nseed = 7\nmethod = \"gbgvd\"\nfront = \"planar\"\nverify = true\n"
      "output = [\"a.ply\", \"b.obj\"]\n",
      {"a.obj", "--seed", "9"});
  CHECK(options.generators.count == 12);
  CHECK(options.generators.seed == 9);
  CHECK(options.diagram.front == Front::planar);
  CHECK(options.compute.verify);
  CHECK(options.output.files == std::vector<std::string>{"a.ply", "b.obj"});
  CHECK(with("vertices = \"1,2\"\n", {"a.obj"}).generators.vertices.vertices == std::vector<std::int64_t>{1, 2});
  CHECK(with("vertices = [1, 2]\n", {"a.obj"}).generators.vertices.vertices == std::vector<std::int64_t>{1, 2});
  CHECK(with("max-memory = 1000000000\n", {"a.obj", "-n", "3"}).compute.max_memory == 1000000000);
  CHECK(with("max-memory = 1e9\n", {"a.obj", "-n", "3"}).compute.max_memory == 1000000000);
  CHECK_THROWS_AS(with("nonsense = 3\n", {"a.obj", "-n", "3"}), Error);
  CHECK_THROWS_AS(with("seed = minus\n", {"a.obj", "-n", "3"}), Error);
  const SharedOptions chosen =
      with("method = \"gbgvd\"\nfront = \"planar\"\n", {"a.obj", "-n", "3", "--method", "exact"});
  CHECK(chosen.diagram.method == Method::exact);
  CHECK_FALSE(chosen.diagram.front);
  const SharedOptions listed = with("n = 12\nsampling = \"random\"\n", {"a.obj", "--radius", "2"});
  CHECK_FALSE(listed.generators.count);
  CHECK(listed.generators.sampling == Sampling::farthest);
  const Options file = with("output = \"-\"\noutput-format = \"json\"\n", {"a.obj", "-n", "3", "-o", "a.obj"});
  CHECK(format_of(file.output, "-") == "ply");
}

TEST_CASE("a list of vertices has one index between each two commas") {
  using Indices = std::vector<std::int64_t>;
  const auto read = [](const std::string& list) {
    return parse_options({"a.obj", "--vertices", list}).generators.vertices.vertices;
  };
  CHECK(read("3") == Indices{3});
  CHECK(read("3, 17 ,\t99") == Indices{3, 17, 99});
  CHECK(read("9223372036854775807") == Indices{9223372036854775807});
  CHECK(parse_options({"a.obj", "--vertices", "3,17", "--vertices", "99"}).generators.vertices.vertices ==
        Indices{3, 17, 99});
  for (const char* wrong : {"", ",", "1,", "1,,2", "-1", "1.0", "0x1", "9223372036854775808"}) {
    CAPTURE(wrong);
    CHECK_THROWS_AS(read(wrong), Error);
  }
}

TEST_CASE("a file of -o that begins with = is a slip") {
  CHECK_THROWS_WITH(parse_options({"a.obj", "-n", "3", "-o=a.ply"}),
                    "-o: '=a.ply' begins with =; write -o a.ply (see gvd-test --help)");
  CHECK(parse_options({"a.obj", "-n", "3", "--output=a.ply"}).output.files == std::vector<std::string>{"a.ply"});
}

}  // namespace gvd::test_shared_options
