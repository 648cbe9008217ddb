#include "common/options/config_options.hpp"
#include "gvd/error.hpp"
#include "support/catch.hpp"

namespace gvd::test_config_options {

using namespace app;
using Catch::Matchers::Contains;

const std::deque<DeclaredOption> kDeclared{
    {{"INPUT", "", ""}, false, {}},
    {{"-n,--count", "", "", "", {}, {}, ValueKind::whole}, false, {}},
    {{"--radius", "", "", "", {}, {}, ValueKind::number}, false, {}},
    {{"--vertices", "", "", "", {}, {}, ValueKind::whole}, true, {}},
    {{"--input-format", "", ""}, false, {}},
    {{"--cut", "", "", "", {}, {}, ValueKind::flag}, false, {}},
    {{"--max-memory", "", "", "", {}, {}, ValueKind::size}, false, {}},
};

std::vector<GivenOption> find(const std::string& toml) {
  return find_config_options(parse_config(toml, "f"), kDeclared);
}

TEST_CASE("a key is any name of an option without its dashes") {
  CHECK(find("n = 3").at(0).option == &kDeclared[1]);
  CHECK(find("count = 3").at(0).values == std::vector<std::string>{"3"});
  CHECK(find("input = '-'").at(0).option == &kDeclared[0]);
  CHECK(find("input-format = 'off'").at(0).name == "input-format");
  for (const char* wrong :
       {"INPUT = 'a'", "input_format = 'off'", "-n = 3", "\"--count\" = 3", "N = 3", "help = true"}) {
    CHECK_THROWS_WITH(find(wrong), Contains("f:1:1: ") && Contains("is no option"));
  }
}

TEST_CASE("each option takes values of its type only") {
  CHECK(find("radius = 3").at(0).values == std::vector<std::string>{"3"});
  CHECK(find("radius = 1e-300").at(0).values == std::vector<std::string>{"1e-300"});
  CHECK(find("vertices = '3,17'").at(0).values == std::vector<std::string>{"3,17"});
  CHECK(find("vertices = 3").at(0).values == std::vector<std::string>{"3"});
  CHECK(find("vertices = [3, 17]").at(0).values == std::vector<std::string>{"3", "17"});
  CHECK(find("max-memory = '2G'").at(0).values == std::vector<std::string>{"2G"});
  CHECK(find("max-memory = 1000000000").at(0).values == std::vector<std::string>{"1000000000"});
  CHECK(find("cut = false").at(0).values == std::vector<std::string>{"false"});
  for (const char* wrong : {"n = 3.0", "n = '3'", "n = [3]", "n = true", "radius = '1'", "vertices = 1.5",
                            "vertices = []", "vertices = [[1]]", "input = 3", "input = ['a']", "cut = 1",
                            "cut = 'true'", "cut.a = 1", "max-memory = true"}) {
    CAPTURE(wrong);
    CHECK_THROWS_WITH(find(wrong), Contains("f:1:") && Contains(": expected ") && Contains(", found a"));
  }
}

TEST_CASE("a table is no option") {
  CHECK_THROWS_WITH(find("[options]\nn = 3"), Contains("f:1:2: options: is a table; write its keys without one"));
}

TEST_CASE("two keys of one option are refused") {
  CHECK_THROWS_WITH(find("count = 3\nradius = 1\nn = 3"), Contains("f:3:1: n: is the same option as count above"));
}

TEST_CASE("a key with control characters or of many letters makes a message of one short line") {
  CHECK_THROWS_WITH(find("\"a\\nb\" = 1"), Contains(": a b: is no option"));
  CHECK_THROWS_WITH(find("\"" + std::string(500, 'x') + "\" = 1"), Contains("xxx...: is no option"));
}

}  // namespace gvd::test_config_options
