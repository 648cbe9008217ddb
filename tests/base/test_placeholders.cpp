#include <string>

#include "gvd/placeholders.hpp"
#include "support/catch.hpp"

namespace gvd::test_placeholders {

std::string in_brackets(std::string_view name, std::string_view value) {
  return std::string(name) + '(' + std::string(value) + ')';
}

TEST_CASE("placeholders are spelled, with their values") {
  const auto spell = [](const std::string& text) { return spell_options(text, {in_brackets}); };
  CHECK(spell("add {option:method=gbgvd}, or leave {option:front} out") == "add method(gbgvd), or leave front() out");
  CHECK(spell("{option:a}") == "a()");
  CHECK(spell("{option:a=b=c}") == "a(b=c)");
  CHECK(spell("").empty());
}

TEST_CASE("what only looks like a placeholder stays") {
  CHECK(spell_options("no {other} {option:") == "no {other} {option:");
  CHECK(spell_options("{given:") == "{given:");
}

TEST_CASE("of several options those are told that were given, or all where none was") {
  const auto spell = [](std::string_view given) {
    return spell_options("leave {given:a|b=false|c} out",
                         {in_brackets, [&](std::string_view name) { return given.find(name) != given.npos; }});
  };
  CHECK(spell("b") == "leave b(false) out");
  CHECK(spell("ac") == "leave a() or c() out");
  CHECK(spell("") == "leave a() or b(false) or c() out");
}

TEST_CASE("without a spelling of its own a text has the names of fields") {
  CHECK(spell_options("raise {option:max_snap} or give {option:refine=false}") ==
        "raise max_snap or give refine=false");
}

}  // namespace gvd::test_placeholders
