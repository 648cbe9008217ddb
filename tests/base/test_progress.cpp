#include <string>
#include <vector>

#include "gvd/error.hpp"
#include "gvd/progress.hpp"
#include "support/catch.hpp"

namespace gvd::test_progress {

TEST_CASE("progress: an empty callback is skipped") { CHECK_NOTHROW(report_progress({}, "step", 0.5)); }

TEST_CASE("progress: the callback gets the step and the fraction") {
  std::vector<std::pair<std::string, double>> calls;
  const Progress progress = [&](std::string_view step, double fraction) {
    calls.emplace_back(step, fraction);
    return true;
  };
  report_progress(progress, "first", 0);
  report_progress(progress, "second", 1);
  CHECK(calls == std::vector<std::pair<std::string, double>>{{"first", 0}, {"second", 1}});
}

TEST_CASE("progress: returning false interrupts, and the error names the step") {
  const Progress progress = [](std::string_view, double) { return false; };
  try {
    report_progress(progress, "bisectors", 0.5);
    FAIL("not interrupted");
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::interrupted);
    CHECK_THAT(error.what(), Catch::Matchers::Contains("bisectors"));
  }
}

}  // namespace gvd::test_progress
