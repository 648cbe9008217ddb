#include "apps/common/options/parse_options.hpp"
#include "common/options/typed_options.hpp"
#include "gvd/error.hpp"
#include "support/catch.hpp"

namespace gvd::test_typed_options {

using namespace app;
using Catch::Matchers::Contains;
using gvd::test::parse_line;

enum class Colour { red, green };

struct Fixture {
  Fixture() {
    add_number(line, {"--count", "", "A count"}, count, kCount);
    add_number(line, {"--length", "", "A length"}, length, kPositive);
    add_choice(line, {"--colour", "", "A colour"}, colour,
               Choices<Colour>{{"red", Colour::red}, {"green", Colour::green}});
    add_text(line, {"--name", "TEXT", "A name"}, name);
  }
  CommandLine line{"gvd-test", "A test.", "1", ""};
  std::int32_t count = 0;
  std::optional<double> length;
  Colour colour = Colour::red;
  std::string name;
};

TEST_CASE("numbers, choices and texts are stored") {
  Fixture fixture;
  parse_line(fixture.line, {"--count", "010", "--length", "2.5e-1", "--colour", "green", "--name", " a b "});
  CHECK(fixture.count == 10);
  CHECK(fixture.length == 0.25);
  CHECK(fixture.colour == Colour::green);
  CHECK(fixture.name == " a b ");
}

TEST_CASE("a wrong value is refused with what is expected, and the target stays") {
  const auto refused = [](const char* option, const char* value, const char* part) {
    Fixture fixture;
    CAPTURE(option, value);
    try {
      parse_line(fixture.line, {option, value});
      FAIL("it was taken");
    } catch (const Error& error) {
      CHECK_THAT(error.what(), Contains(std::string("'") + value + "'") && Contains(part));
    }
    CHECK(fixture.count == 0);
    CHECK(!fixture.length);
    CHECK(fixture.colour == Colour::red);
  };
  refused("--count", "0", "is not a whole number from 1 to 2147483647");
  refused("--count", "1.5", "is not a whole number from 1 to 2147483647");
  refused("--length", "nan", "is not a finite number above 0");
  refused("--length", "inf", "is not a finite number above 0");
  refused("--length", "1,5", "is not a finite number above 0");
  refused("--colour", "blue", "is none of red|green");
}

TEST_CASE("help shows the type of each option") {
  Fixture fixture;
  const std::string help = parse_line(fixture.line, {"--help"}).value();
  for (const char* part : {"--count N", "--length NUMBER", "--colour red|green", "--name TEXT"}) {
    CHECK_THAT(help, Contains(part));
  }
}

}  // namespace gvd::test_typed_options
