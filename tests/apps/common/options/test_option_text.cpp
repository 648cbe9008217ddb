#include "common/options/option_text.hpp"
#include "support/catch.hpp"

namespace gvd::test_option_text {

using namespace app;

TEST_CASE("names are split at commas") {
  CHECK(split_names("-n,--count") == std::vector<std::string>{"-n", "--count"});
  CHECK(split_names("INPUT") == std::vector<std::string>{"INPUT"});
}

TEST_CASE("an option is given by any of its names, with any of its values, unless it is a flag that is false") {
  const DeclaredOption output{{"-o,--output", "", ""}, true, {}};
  const GivenOption files{&output, "-o", "", {"a.ply", "-"}};
  for (const char* wanted : {"-o", "--output", "-o -", "--output a.ply"}) CHECK(is_given_as(files, wanted));
  for (const char* wanted : {"--out", "--output b.ply", "-"}) CHECK(!is_given_as(files, wanted));
  const DeclaredOption quiet{{"--quiet", "", "", "", {}, {}, ValueKind::flag}, false, {}};
  CHECK(is_given_as({&quiet, "", "", {"true"}}, "--quiet"));
  CHECK(!is_given_as({&quiet, "", "", {"false"}}, "--quiet"));
}

TEST_CASE("texts of the user's are printable and short in messages, and keep their letters whole") {
  CHECK(printable("-n") == "-n");
  CHECK(printable(std::string("a\n\0\x1b", 4) + "\x7f") == "a    ");
  CHECK(printable(std::string(61, 'a')) == std::string(60, 'a') + "...");
  CHECK(printable("k\u00e4se", 3) == "k\u00e4...");
  CHECK(printable("k\u00e4se", 2) == "k...");
}

}  // namespace gvd::test_option_text
