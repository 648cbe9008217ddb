#include <string>

#include "io/generators/generator_fixture.hpp"
#include "io/generators/list_fields.hpp"
#include "support/catch.hpp"

namespace gvd::test {
namespace {

using Fields = std::vector<std::string_view>;
const std::string kName = "list";
const detail::ListLocation kLocation{kName, 7};

std::string refused_entry(const Fields& fields) {
  return refusal([&] { detail::parse_entry(fields, kLocation); }, ErrorCode::unreadable_input);
}

}  // namespace

TEST_CASE("lines have their number, and no comment, byte order mark or outer blanks") {
  const auto lines = detail::split_lines("\xef\xbb\xbf# head\n\n  a b \r\nc # d\n\t\n e");
  REQUIRE(lines.size() == 3);
  CHECK(lines[0].text == "a b");
  CHECK(lines[0].number == 3);
  CHECK(lines[1].text == "c");
  CHECK(lines[1].number == 4);
  CHECK(lines[2].text == "e");
  CHECK(lines[2].number == 6);
  CHECK(detail::split_lines("").empty());
}

TEST_CASE("blanks separate fields, however many there are") {
  CHECK(detail::split_blanks("a \t bc  d") == Fields{"a", "bc", "d"});
  CHECK(detail::split_blanks("").empty());
}

TEST_CASE("an entry is a vertex, a face or a position by its number of fields and its first one") {
  CHECK(detail::parse_entry({"5"}, kLocation).kind == GeneratorEntry::Kind::vertex);
  const GeneratorEntry face = detail::parse_entry({"5", "0.5", "0.25", "0.25"}, kLocation);
  CHECK(face.kind == GeneratorEntry::Kind::face);
  CHECK(face.index == 5);
  CHECK(face.line == 7);
  const GeneratorEntry position = detail::parse_entry({"p", "1", "2", "-3"}, kLocation);
  CHECK(position.kind == GeneratorEntry::Kind::position);
  CHECK(position.values == std::array{1.0, 2.0, -3.0});
}

TEST_CASE("a refused entry says what was expected") {
  using Catch::Matchers::Contains;
  CHECK_THAT(refused_entry({"1", "2"}), Contains("list:7: 2 fields; write a vertex 'V'"));
  CHECK_THAT(refused_entry({"-1"}), Contains("'-1' is no index of a vertex; indices are whole numbers from 0"));
  CHECK_THAT(refused_entry({"x", "1", "0", "0"}), Contains("'x' is no index of a face"));
  CHECK_THAT(refused_entry({"p", "1", "nan", "0"}), Contains("'nan' is no finite number"));
}

}  // namespace gvd::test
