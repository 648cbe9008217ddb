#include "apps/common/options/parse_options.hpp"
#include "apps/run_command.hpp"
#include "common/options/check_options.hpp"
#include "support/catch.hpp"
#include "support/refusal.hpp"

namespace gvd::test_check_options {

using namespace app;
using Catch::Matchers::Contains;
using gvd::test::kOutputFormats;
using gvd::test::parse_options;

std::string refusal(const std::vector<std::string>& arguments, ErrorCode code = ErrorCode::invalid_option) {
  CAPTURE(arguments);
  return test::refusal([&] { check_options(parse_options(arguments), kOutputFormats); }, code);
}

TEST_CASE("generators come from exactly one option") {
  CHECK_NOTHROW(check_options(parse_options({"a.obj", "--vertices", "1,2"}), kOutputFormats));
  CHECK(refusal({"a.obj"}) == "no generators: give one of -n, --generators, --vertices or --radius");
  CHECK_THAT(refusal({"a.obj", "-n", "3", "--radius", "1"}), Contains("-n and --radius"));
  CHECK_THAT(refusal({"a.obj", "--vertices", "1", "--generators", "g.txt"}), Contains("--generators and --vertices"));
}

TEST_CASE("a stray word is told as such, with what it may have been meant for") {
  const test::ScratchFolder scratch;
  const std::string mesh = scratch / "a.obj", other = scratch / "b.obj", more = scratch / "c.obj";
  for (const std::string& file : {mesh, other, more}) test::write_text(file, "v 0 0 0\n");
  const auto with = [&](const std::string& word) { return refusal({mesh, word, "-n", "3"}); };
  CHECK(refusal({mesh, "24"}) == "unexpected: '24' is no file; did you mean -n 24?");
  CHECK(with("24") == "unexpected: '24' is no file; options have dashes in front");
  CHECK(refusal({mesh, "--vertices", "1", "2"}) ==
        "unexpected: '2' is no file; --vertices has commas and no blanks: 3,17,99");
  CHECK(refusal({"-n", "3", "--", mesh, "-q"}) == "unexpected: '-q' is no file; options go before --");
  CHECK(with(scratch / "x.ply") ==
        "unexpected: '" + scratch / "x.ply" + "' is no file; did you mean -o " + scratch / "x.ply" + "?");
  CHECK(with("cut") == "unexpected: 'cut' is no file; options have dashes in front");
  CHECK_THAT(with(scratch / ""), Contains("is a directory; did you mean --output-dir "));
  CHECK(refusal({mesh, other, "-n", "3"}) ==
        "2 inputs, " + mesh + " and " + other + ": name a folder for their outputs with --output-dir");
  CHECK_THAT(refusal({mesh, other, more, "-n", "3"}), Contains("3 inputs, " + mesh + " and 2 others: "));
}

TEST_CASE("standard input needs a format") {
  CHECK_THAT(refusal({"-", "-n", "3"}), Contains("--input-format"));
  CHECK_NOTHROW(check_options(parse_options({"-", "-n", "3", "--input-format", "off"}), kOutputFormats));
}

TEST_CASE("an option that the method ignores is refused, with what to do") {
  CHECK_THAT(refusal({"a.obj", "-n", "3", "--front", "planar"}), Contains("add --method gbgvd"));
  CHECK_THAT(refusal({"a.obj", "-n", "3", "--method", "gbgvd", "--chord-tolerance", "1e-3"}),
             Contains("--method gbgvd and --chord-tolerance exclude each other"));
  CHECK_THAT(refusal({"a.obj", "-n", "3", "--chord-tolerance", "1e-11"}), Contains("1e-11") && Contains("1e-10"));
}

TEST_CASE("an option that does nothing is refused") {
  const std::vector<std::vector<std::string>> wrong{
      {"--vertices", "3", "--seed", "1"},
      {"--generators", "g.txt", "--seed", "1"},
      {"--radius", "1", "--sampling", "random"},
      {"-n", "3", "--merge-coincident"},
      {"--vertices", "3", "--max-snap", "1"},
      {"-n", "3", "-o", "a.ply", "--output-format", "obj"},
      {"-n", "3", "-q", "-v"},
  };
  for (std::vector<std::string> arguments : wrong) {
    arguments.insert(arguments.begin(), "a.obj");
    CHECK_THAT(refusal(arguments), Contains("does nothing here: add") || Contains("exclude each other"));
  }
  CHECK_NOTHROW(parse_options({"a.obj", "-n", "3", "-o", "a.ply", "-o", "-", "--output-format", "obj"}));
  CHECK_NOTHROW(parse_options({"a.obj", "--radius", "3", "--seed", "1"}));
}

}  // namespace gvd::test_check_options
