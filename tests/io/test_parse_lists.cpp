// Lines, fields and entries of lists, and lists as text.
#include <string>

#include "gvd/error.hpp"
#include "io/generator_fixture.hpp"
#include "io/parse_lists.hpp"
#include "support/catch.hpp"

namespace gvd::test_parse_lists {

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
  CHECK_THAT(refused({"1", "2"}), Contains("'F,b0,b1,b2', or a position 'x,y,z' or 'p,x,y,z'"));
}

TEST_CASE("a refused entry says what was expected") {
  using Catch::Matchers::Contains;
  CHECK_THAT(refused_entry({"1", "2"}), Contains("list:7: 2 fields; write the number of a vertex, a face with"));
  CHECK_THAT(refused_entry({"-1"}), Contains("'-1' is not an index of a vertex; indices are whole numbers from 0"));
  CHECK_THAT(refused_entry({"x", "1", "0", "0"}), Contains("'x' is not an index of a face"));
  CHECK_THAT(refused_entry({"p", "1", "nan", "0"}), Contains("'nan' is not a finite number"));
}

TEST_CASE("a location is a name and, where there is one, a line") {
  const std::string name = "a.txt";
  CHECK(detail::ListLocation{name, 12}.text() == "a.txt:12");
  CHECK(detail::ListLocation{name}.text() == "a.txt");
  try {
    detail::ListLocation{name, 12}.refuse("wrong");
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::unreadable_input);
    CHECK(error.element() == 11);
    CHECK(std::string(error.what()) == "a.txt:12: wrong");
  }
}

using Kind = GeneratorEntry::Kind;

TEST_CASE("a text list holds vertices, faces with coordinates and positions") {
  const GeneratorList list = parse("\xef\xbb\xbf# three\r\n  17 \r\n\r\n3 0.25 0.5 .25 # a face\np 1e-1 -2 3");
  REQUIRE(list.entries.size() == 3);
  CHECK(list.entries[0].kind == Kind::vertex);
  CHECK(list.entries[0].index == 17);
  CHECK(list.entries[0].line == 2);
  CHECK(list.entries[1].kind == Kind::face);
  CHECK(list.entries[1].index == 3);
  CHECK(list.entries[1].values == std::array{0.25, 0.5, 0.25});
  CHECK(list.entries[2].kind == Kind::position);
  CHECK(list.entries[2].values == std::array{0.1, -2.0, 3.0});
  CHECK(list.entries[2].line == 5);
}

TEST_CASE("a text list of points needs no p") {
  const GeneratorList bare = parse("0 0 0\n1 2 3\n"), named = parse("p 0 0 0\np 1 2 3\n");
  REQUIRE(bare.entries.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(bare.entries[i].kind == Kind::position);
    CHECK(bare.entries[i].values == named.entries[i].values);
  }
}

TEST_CASE("a comma in a text list is told as such") {
  CHECK_THAT(refusal([] { parse("17\n1,2.5,3 # a point\n", GeneratorFormat::text); }, ErrorCode::unreadable_input),
             Catch::Matchers::Contains("list:2: has a comma; separate the fields by blanks, or give the list as CSV"));
}

TEST_CASE("a csv list has the same fields, or named columns") {
  const GeneratorList plain = parse("17\n3, 0.25,0.5,0.25\np,1,2,3\n", GeneratorFormat::csv);
  REQUIRE(plain.entries.size() == 3);
  CHECK(plain.entries[2].values == std::array{1.0, 2.0, 3.0});
  const GeneratorList named =
      parse("id,x,y,z,face,b2,b1,b0,vertex\n0,1,2,3,,,,,\n1,,,,7,0.5,0.25,0.25,\n2,,,,,,,,9\n", GeneratorFormat::csv);
  REQUIRE(named.entries.size() == 3);
  CHECK(named.entries[0].kind == Kind::position);
  CHECK(named.entries[1].index == 7);
  CHECK(named.entries[1].values == std::array{0.25, 0.25, 0.5});
  CHECK(named.entries[2].kind == Kind::vertex);
  CHECK(named.entries[2].line == 4);
  CHECK(parse("\"vertex\"\n\"4\"\n", GeneratorFormat::csv).entries[0].index == 4);
}

TEST_CASE("a csv list without a header takes three numbers for a position, but no list of vertices on one line") {
  CHECK(parse("0,0,0\n", GeneratorFormat::csv).entries[0].kind == Kind::position);
  CHECK_THAT(refusal([] { parse("3,17,99\n", GeneratorFormat::csv); }, ErrorCode::unreadable_input),
             Catch::Matchers::Contains("list:1: '3,17,99' could be"));
}

}  // namespace gvd::test_parse_lists
