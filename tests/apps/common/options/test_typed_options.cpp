// Kinds of options, and the numbers and sizes that they read.

#include <clocale>

#include "apps/common/options/parse_options.hpp"
#include "common/options/typed_options.hpp"
#include "gvd/error.hpp"
#include "support/catch.hpp"

namespace gvd::test_typed_options {

using namespace app;
using Catch::Matchers::Contains;
using gvd::test::parse_line;

TEST_CASE("a number is the whole text, in any locale") {
  std::setlocale(LC_ALL, "de_DE.UTF-8");
  CHECK(parse_number<double>("1.5") == 1.5);
  CHECK(parse_number<double>("-2e-3") == -2e-3);
  CHECK(!parse_number<double>("1,5"));
  std::setlocale(LC_ALL, "C");
  CHECK(parse_number<int>("010") == 10);
  for (const char* wrong : {"", " 1", "1 ", "+1", "1x", "0x10", "one", "99999999999"}) {
    CAPTURE(wrong);
    CHECK(!parse_number<int>(wrong));
  }
  CHECK(parse_number<std::uint64_t>("18446744073709551615") == 18446744073709551615u);
  CHECK(!parse_number<std::uint64_t>("-1"));
}

TEST_CASE("a range holds its ends, and no NaN") {
  CHECK(parse_number_in("1", kCount) == 1);
  CHECK(!parse_number_in("0", kCount));
  CHECK(parse_number_in("0", kNotNegative) == 0.0);
  CHECK(!parse_number_in("-0.1", kNotNegative));
  CHECK(!parse_number_in("0", kPositive));
  CHECK(parse_number_in("1e-300", kPositive) == 1e-300);
  for (const char* wrong : {"nan", "-nan", "inf", "1e999"}) CHECK(!parse_number_in(wrong, kNotNegative));
}

std::optional<std::int64_t> bytes_of(const std::string& text) {
  std::optional<std::int64_t> bytes;
  return parse_size(text, bytes).empty() ? bytes : std::nullopt;
}

std::string refusal_of_size(const std::string& text) {
  std::optional<std::int64_t> bytes;
  return parse_size(text, bytes);
}

TEST_CASE("sizes have binary units, in any spelling") {
  CHECK(bytes_of("1") == 1);
  CHECK(bytes_of("500K") == 500 * 1024);
  CHECK(bytes_of("500m") == 500LL << 20);
  CHECK(bytes_of("2G") == 2LL << 30);
  CHECK(bytes_of("1.5GiB") == 3LL << 29);
  CHECK(bytes_of("3TB") == 3LL << 40);
  CHECK(bytes_of("7b") == 7);
}

TEST_CASE("what is no size is refused") {
  for (const char* text : {"", "G", "B", "1X", "1 G", "1GG", "1i", "nan", "inf", "G1", "1e", "infK"}) {
    CAPTURE(text);
    CHECK_THAT(refusal_of_size(text), Contains("is not a size; write a number with K, M, G or T, such as 500M or 2G"));
  }
}

TEST_CASE("sizes that no memory has are told as such") {
  for (const char* text : {"1e30", "1e999", "1048577T", "99999999999999999999"}) {
    CAPTURE(text);
    CHECK_THAT(refusal_of_size(text), Contains("is too large; write at most 1048576T"));
  }
  for (const char* text : {"0", "0.2", "-1G", "1e-999"}) {
    CAPTURE(text);
    CHECK_THAT(refusal_of_size(text), Contains("is less than a byte"));
  }
  CHECK(bytes_of("1048576T") == std::int64_t{1} << 60);
}

enum class Colour { red, green };

struct Fixture {
  Fixture() {
    line.set_help_flag();
    line.add_flag_callback("--help", [] { throw CLI::CallForHelp(); });
    add_number(line, "--count", count, kCount, "A count");
    add_number(line, "--length", length, kPositive, "A length");
    add_choice(line, "--colour", colour, Choices<Colour>{{"red", Colour::red}, {"green", Colour::green}}, "A colour");
    add_file(line, "--name", name, "A name", "TEXT");
    add_flag(line, "--flag", flag, "A flag");
    add_flag(line, "--other", other, "Another flag")->excludes("--flag");
  }
  CLI::App line{"A test.", "gvd-test"};
  std::int32_t count = 0;
  std::optional<double> length;
  Colour colour = Colour::red;
  std::string name;
  bool flag = false, other = false;
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
  refused("--colour", "blue", "is not one of red|green");
}

TEST_CASE("help shows the type of each option") {
  Fixture fixture;
  const std::string help = fixture.line.help("", CLI::AppFormatMode::All);
  for (const char* part : {"--count N", "--length NUMBER", "--colour red|green", "--name TEXT"}) {
    CHECK_THAT(help, Contains(part));
  }
}

TEST_CASE("a flag that is turned off is as good as not given") {
  Fixture fixture;
  parse_line(fixture.line, {"--flag=false", "--other"});
  CHECK(!fixture.flag);
  CHECK(fixture.other);
  parse_line(fixture.line, {"--flag", "--other=false"});
  CHECK(fixture.flag);
  CHECK(!fixture.other);
}

}  // namespace gvd::test_typed_options
