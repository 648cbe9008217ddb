#include "io/generators/generator_fixture.hpp"
#include "io/generators/parse_text.hpp"
#include "support/catch.hpp"

namespace gvd::test_parse_text {

using namespace test;

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
             Catch::Matchers::Contains("list:2: has a comma; part the fields by blanks, or give the list as CSV"));
}

}  // namespace gvd::test_parse_text
