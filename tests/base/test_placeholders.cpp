#include <string>

#include "gvd/placeholders.hpp"
#include "support/catch.hpp"

namespace gvd::test_placeholders {

std::string in_brackets(std::string_view name, std::string_view value) {
  return std::string(name) + '(' + std::string(value) + ')';
}

TEST_CASE("placeholders are spelled, with their values") {
  const auto spell = [](const std::string& text) { return spell_options(text, {in_brackets}); };
  CHECK(spell("add \1method=gbgvd\2, or leave \1front\2 out") == "add method(gbgvd), or leave front() out");
  CHECK(spell("\1a\2") == "a()");
  CHECK(spell("\1a=b=c\2") == "a(b=c)");
  CHECK(spell("").empty());
}

TEST_CASE("a text without the two characters has no placeholder, and one of them alone is not shown") {
  CHECK(spell_options("{option:count} {} a\\1b?c") == "{option:count} {} a\\1b?c");
  CHECK(spell_options("a\1b") == "ab");
  CHECK(spell_options("\1") == "");
  CHECK(has_placeholder_mark("a\2b"));
  CHECK(!has_placeholder_mark("a\3{option:b}"));
}

TEST_CASE("a placeholder is made of a name and a value, and is known at the beginning of a text") {
  CHECK(placeholder("count") == "\1count\2");
  CHECK(placeholder("output", "a=b.ply") == "\1output=a=b.ply\2");
  CHECK(first_option(placeholder("output", "a=b.ply") + ": there") == "output");
  CHECK(first_option("\1count\2") == "count");
  CHECK(first_option("raise \1count\2").empty());
}

TEST_CASE("of several options those are told that were given, or all where none was") {
  const auto spell = [](std::string_view given) {
    return spell_options("leave \1?a|b=false|c\2 out",
                         {in_brackets, [&](std::string_view name) { return given.find(name) != given.npos; }});
  };
  CHECK(spell("b") == "leave b(false) out");
  CHECK(spell("ac") == "leave a() or c() out");
  CHECK(spell("") == "leave a() or b(false) or c() out");
}

TEST_CASE("advice is left out where its option can't be given") {
  const auto spell = [](bool can_give) {
    return spell_options(
        "remove one\1+, or give |merge=true\2; done",
        {.spell = in_brackets, .can_give = [&](std::string_view name) { return can_give && name == "merge"; }});
  };
  CHECK(spell(true) == "remove one, or give merge(true); done");
  CHECK(spell(false) == "remove one; done");
}

TEST_CASE("without a spelling of its own a text has the names of fields") {
  CHECK(spell_options("raise \1max_snap\2 or give \1refine=false\2") == "raise max_snap or give refine=false");
}

}  // namespace gvd::test_placeholders
