#include "common/options/merge_options.hpp"
#include "gvd/error.hpp"
#include "support/catch.hpp"

namespace gvd::test_merge_options {

using namespace app;

const DeclaredOption kCount{{"-n,--count", "", "", "", {}, {"--list"}}, false, {}};
const DeclaredOption kList{{"--list", "", "", "", {}, {"-n"}}, false, {}};
const DeclaredOption kSeed{{"--seed", "", "", "", {"-n"}}, false, {}};
const DeclaredOption kMethod{{"--method", "", ""}, false, {}};
const DeclaredOption kFront{{"--front", "", "", "", {"--method fast"}}, false, {}};
const DeclaredOption kChord{{"--chord", "", "", "", {}, {"--method fast"}}, false, {}};
const DeclaredOption kQuiet{{"--quiet", "", "", "", {}, {}, ValueKind::flag}, false, {}};
const DeclaredOption kVerbose{{"--verbose", "", "", "", {}, {"--quiet"}, ValueKind::flag}, false, {}};

GivenOption given(const DeclaredOption& option, const std::string& value, const std::string& place = "") {
  return {&option, split_names(option.text.names).front(), place, {value}};
}

GivenOption filed(const DeclaredOption& option, const std::string& value) { return given(option, value, "f:1:1"); }

/// The options that are left of the file.
std::vector<const DeclaredOption*> left(const GivenOption& line, const std::vector<GivenOption>& file) {
  std::vector<const DeclaredOption*> options;
  for (const GivenOption& one : merge_options({line}, file)) {
    if (!one.place.empty()) options.push_back(one.option);
  }
  return options;
}

std::string refusal(const std::vector<GivenOption>& options) {
  try {
    check_together(options);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

using Options = std::vector<const DeclaredOption*>;

TEST_CASE("the line overrides the same option, what it excludes, and what needs that") {
  const std::vector<GivenOption> file{filed(kCount, "3"), filed(kSeed, "1"), filed(kMethod, "fast")};
  CHECK(left(given(kCount, "9"), file) == Options{&kSeed, &kMethod});
  CHECK(left(given(kSeed, "9"), file) == Options{&kCount, &kMethod});
  CHECK(left(given(kList, "a"), file) == Options{&kMethod});
  CHECK(left(given(kQuiet, "true"), {filed(kVerbose, "true")}).empty());
  CHECK(left(given(kQuiet, "false"), {filed(kVerbose, "true")}) == Options{&kVerbose});
}

TEST_CASE("a value of the line rules out what needs another one") {
  const std::vector<GivenOption> file{filed(kMethod, "fast"), filed(kFront, "a")};
  CHECK(left(given(kMethod, "exact"), file).empty());
  CHECK(left(given(kMethod, "fast"), file) == Options{&kFront});
  CHECK(left(given(kChord, "1"), file).empty());
}

TEST_CASE("options that exclude each other, and options that do nothing, are refused") {
  CHECK(refusal({given(kCount, "3"), given(kList, "a")}) == "-n and --list exclude each other: keep one");
  CHECK(refusal({given(kMethod, "fast"), given(kChord, "1")}) ==
        "--method fast and --chord exclude each other: keep one");
  CHECK(refusal({given(kMethod, "exact"), given(kChord, "1")}).empty());
  CHECK(refusal({given(kSeed, "3")}) == "--seed does nothing here: add -n, or leave --seed out");
  CHECK(refusal({given(kMethod, "exact"), filed(kFront, "a")}) ==
        "f:1:1: --front does nothing here: add --method fast, or leave --front out");
  CHECK(refusal({given(kQuiet, "true"), given(kVerbose, "false")}).empty());
  CHECK(refusal({given(kCount, "3"), given(kSeed, "1")}).empty());
}

}  // namespace gvd::test_merge_options
