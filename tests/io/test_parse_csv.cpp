#include "io/generator_fixture.hpp"
#include "io/parse_lists.hpp"
#include "support/catch.hpp"

namespace gvd::test_parse_csv {

using namespace test;

using Kind = GeneratorEntry::Kind;

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

}  // namespace gvd::test_parse_csv
