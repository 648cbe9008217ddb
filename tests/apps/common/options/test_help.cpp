// The help of a command.

#include "common/options/help.hpp"
#include "options/toy_options.hpp"
#include "support/catch.hpp"

namespace gvd::test_help {

using namespace app;

const CommandInfo kWords{
    "x", "A test that has a description of so many words that they do not fit into one line of the help.",
    "  x a.obj\n"};

TEST_CASE("words wrap before the width, and a longer word stands alone") {
  CHECK(wrap("one two three", 7, 2) == "one two\n  three");
  CHECK(wrap("one two three", 6, 0) == "one\ntwo\nthree");
  CHECK(wrap("a verylongword b", 5, 1) == "a\n verylongword\n b");
  CHECK(wrap("  ", 5, 1).empty());
}

TEST_CASE("options are listed in groups, in full or with their first line") {
  OptionList list;
  std::vector<std::string> inputs;
  std::string file;
  bool quiet = false;
  double length = 0.5;
  list.group("Input");
  list.option("input", File{&inputs}, {.help = "The mesh", .more = ", or -", .shown = Shown::main, .positional = true});
  list.group("Output");
  list.option("output_with_a_long_name", File{&file}, {.help = "Write it"});
  list.group("Input");
  list.option("length", Number{&length},
              {.help = "Its length", .more = "; see \1quiet\2", .unit = "mesh units", .shown = Shown::main});
  list.group("General");
  list.option("quiet", Flag{&quiet}, {.help = "Say nothing but errors", .short_name = "q"});
  list.option("secret", Flag{&quiet}, {.help = "Hidden", .shown = Shown::hidden});
  const std::string head =
      "A test that has a description of so many words that they do not fit into one\n"
      "line of the help.\n"
      "\nUsage: x [OPTIONS] INPUT...\n";
  CHECK(make_help(kWords, list) ==
        head +
            "\nInput:\n"
            "  INPUT                   The mesh, or -\n"
            "  --length NUMBER         Its length, in mesh units; see -q (default: 0.5)\n"
            "\nOutput:\n"
            "  --output-with-a-long-name FILE\n"
            "                          Write it\n"
            "\nGeneral:\n"
            "  -q, --quiet             Say nothing but errors\n" +
            "\nExamples:\n"
            "  x a.obj\n"
            "\nExit codes: 0 done, 2 usage, 3 unreadable input, 4 input breaks a "
            "precondition,\n"
            "5 no valid result or out of memory, 6 output could not be written,\n"
            "130 interrupted; with several inputs, the code of the first one that failed.\n");
  CHECK(make_short_help(kWords, list) == head +
                                             "\n  INPUT                   The mesh\n"
                                             "  --length NUMBER         Its length\n"
                                             "\nAll options, and examples: x --help\n");
}

}  // namespace gvd::test_help
