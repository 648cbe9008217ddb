#include "common/options/help_text.hpp"
#include "support/catch.hpp"

namespace gvd::test_help_text {

using namespace app;

TEST_CASE("words wrap before the width, and a longer word stands alone") {
  CHECK(wrap("one two three", 7, 2) == "one two\n  three");
  CHECK(wrap("one two three", 6, 0) == "one\ntwo\nthree");
  CHECK(wrap("a verylongword b", 5, 1) == "a\n verylongword\n b");
  CHECK(wrap("  ", 5, 1).empty());
}

TEST_CASE("options are listed in groups, with those of no group last") {
  const std::string text = describe_options({{"-q,--quiet", "", "Say nothing but errors"},
                                             {"INPUT", "", "The mesh", "Input"},
                                             {"--output-with-a-long-name", "FILE", "Write it", "Output"},
                                             {"--input-format", "F", "Its format", "Input"}});
  CHECK(text ==
        "\nInput:\n"
        "  INPUT                   The mesh\n"
        "  --input-format F        Its format\n"
        "\nOutput:\n"
        "  --output-with-a-long-name FILE\n"
        "                          Write it\n"
        "\nGeneral:\n"
        "  -q, --quiet             Say nothing but errors\n");
}

}  // namespace gvd::test_help_text
