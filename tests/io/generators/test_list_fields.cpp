#include <string>

#include "io/generators/generator_fixture.hpp"
#include "io/generators/list_fields.hpp"
#include "support/catch.hpp"

namespace gvd::test_list_fields {

using namespace test;

using Fields = std::vector<std::string_view>;
const std::string kName = "list";

GeneratorEntry parse_entry(const Fields& fields) { return detail::parse_entries({{fields, 7}}, kName, ' ').front(); }

std::string refused_entry(const Fields& fields) {
  return refusal([&] { parse_entry(fields); }, ErrorCode::unreadable_input);
}

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
  CHECK(detail::split_fields("a \t bc  d") == Fields{"a", "bc", "d"});
  CHECK(detail::split_fields("a,b ,c", ',') == Fields{"a", "b", "c"});
  CHECK(detail::split_fields(",, a,,b\t,", ',') == Fields{"a", "b"});
  CHECK(detail::split_fields("a,b") == Fields{"a,b"});
  CHECK(detail::split_fields("").empty());
  CHECK(detail::split_fields(" , ", ',').empty());
}

TEST_CASE("an entry is a vertex, a face or a position by its number of fields and its first one") {
  CHECK(parse_entry({"5"}).kind == GeneratorEntry::Kind::vertex);
  const GeneratorEntry face = parse_entry({"5", "0.5", "0.25", "0.25"});
  CHECK(face.kind == GeneratorEntry::Kind::face);
  CHECK(face.index == 5);
  CHECK(face.line == 7);
  const GeneratorEntry position = parse_entry({"p", "1", "2", "-3"});
  CHECK(position.kind == GeneratorEntry::Kind::position);
  CHECK(position.values == std::array{1.0, 2.0, -3.0});
}

TEST_CASE("three numbers are a position, with or without a p before them") {
  for (const Fields& fields : {Fields{"0", "0", "0"}, Fields{"1", "2", "-3"}, Fields{"1", "2.5", "3"}}) {
    Fields named = fields;
    named.insert(named.begin(), "p");
    const GeneratorEntry bare = parse_entry(fields), with_p = parse_entry(named);
    CHECK(bare.kind == GeneratorEntry::Kind::position);
    CHECK(bare.values == with_p.values);
    CHECK(bare.line == 7);
  }
}

TEST_CASE("three different indices are not taken for a position, unless the list holds others that are one") {
  using Catch::Matchers::Contains;
  CHECK_THAT(refused_entry({"3", "17", "99"}),
             Contains("list:7: '3 17 99' could be a position or three vertices; write 'p 3 17 99'"));
  const detail::ListRow vertex{{"17"}, 1}, indices{{"1", "2", "3"}, 2}, position{{"1", "2.5", "3"}, 3};
  CHECK_THAT(refusal(
                 [&] {
                   detail::parse_entries({vertex, indices}, kName, ' ');
                 },
                 ErrorCode::unreadable_input),
             Contains("list:2: "));
  const auto entries = detail::parse_entries({vertex, indices, position}, kName, ' ');
  CHECK(entries[0].kind == GeneratorEntry::Kind::vertex);
  CHECK(entries[1].values == std::array{1.0, 2.0, 3.0});
}

TEST_CASE("a refusal writes entries with the separator of the list") {
  using Catch::Matchers::Contains;
  const auto refused = [](const Fields& fields) {
    return refusal([&] { detail::parse_entries({{fields, 7}}, kName, ','); }, ErrorCode::unreadable_input);
  };
  CHECK_THAT(refused({"3", "17", "99"}),
             Contains("'3,17,99' could be a position or three vertices; write 'p,3,17,99'"));
  CHECK_THAT(refused({"1", "2"}), Contains("'F,b0,b1,b2' or a position 'x,y,z' or 'p,x,y,z'"));
}

TEST_CASE("a refused entry says what was expected") {
  using Catch::Matchers::Contains;
  CHECK_THAT(refused_entry({"1", "2"}), Contains("list:7: 2 fields; write a vertex 'V'"));
  CHECK_THAT(refused_entry({"-1"}), Contains("'-1' is no index of a vertex; indices are whole numbers from 0"));
  CHECK_THAT(refused_entry({"x", "1", "0", "0"}), Contains("'x' is no index of a face"));
  CHECK_THAT(refused_entry({"p", "1", "nan", "0"}), Contains("'nan' is no finite number"));
}

}  // namespace gvd::test_list_fields
