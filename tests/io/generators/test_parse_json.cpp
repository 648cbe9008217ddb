#include "io/generators/generator_fixture.hpp"
#include "io/generators/parse_json.hpp"
#include "support/catch.hpp"

namespace gvd::test {

using Kind = GeneratorEntry::Kind;

TEST_CASE("a json list is the array of generators of any object") {
  const GeneratorList list = parse(R"({"schema": "gvd-diagram/1", "cells": [{"generators": [{"vertex": 1}]}],
    "generators": [{"face": 3, "bary": [0.25, 0.5, 0.25], "position": [9, 9, 9]},
                   {"vertex": 5},
                   {"position": [1, 2, 3]}]})",
                                   GeneratorFormat::json);
  REQUIRE(list.entries.size() == 3);
  CHECK(list.entries[0].index == 3);
  CHECK(list.entries[0].line == 2);
  CHECK(list.entries[1].kind == Kind::vertex);
  CHECK(list.entries[1].line == 3);
  CHECK(list.entries[2].values == std::array{1.0, 2.0, 3.0});
  CHECK(list.entries[2].line == 4);
}

}  // namespace gvd::test
