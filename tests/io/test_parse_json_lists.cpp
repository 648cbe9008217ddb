#include <algorithm>
#include <string>

#include "io/generator_fixture.hpp"
#include "io/parse_json_lists.hpp"
#include "support/catch.hpp"

namespace gvd::test_parse_json_lists {

using namespace test;

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

TEST_CASE("a message about wrong json is one short printable line, whatever the file holds") {
  const std::string wrong = "{\"generators\": [\x7f\x1b" + std::string(5000, 'x') + "]}";
  for (const std::string& text : {wrong, "[\"" + std::string(5000, 'y') + "\n\"]"}) {
    const std::string message = refusal([&] { parse(text, GeneratorFormat::json); }, ErrorCode::unreadable_input);
    CHECK(message.size() < 300);
    CHECK(std::all_of(message.begin(), message.end(), [](char c) { return c >= ' ' && c <= '~'; }));
  }
}

}  // namespace gvd::test_parse_json_lists
