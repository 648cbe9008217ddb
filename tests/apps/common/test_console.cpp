#include <unistd.h>

#include <cstdio>

#include "apps/run_command.hpp"
#include "common/console.hpp"
#include "support/catch.hpp"

namespace gvd::test_console {

using namespace app;
using Catch::Matchers::Contains;

/// What a call prints on standard error.
template <class Call>
std::string stderr_of(Call call) {
  const test::ScratchFolder scratch;
  const int kept = ::dup(STDERR_FILENO);
  REQUIRE(std::freopen((scratch / "err").c_str(), "w", stderr) != nullptr);
  call();
  std::fflush(stderr);
  ::dup2(kept, STDERR_FILENO);
  ::close(kept);
  return test::read_text(scratch / "err");
}

TEST_CASE("a bar fits its terminal") {
  for (int width = 1; width < 200; ++width) {
    for (const double fraction : {-1.0, 0.0, 0.333, 1.0, 2.0}) {
      for (const char* status : {"", "12/100, energy 0.00123457, and more that nobody needs to read in one line"}) {
        const std::string bar =
            render_bar({"a step with a rather long name", status, fraction, 3541}, {true, false, width});
        CAPTURE(width, fraction, bar);
        CHECK(static_cast<int>(bar.size()) <= std::max(6, width - 1));
        CHECK(bar.find('\n') == std::string::npos);
      }
    }
  }
}

TEST_CASE("a bar shows its part") {
  const ConsoleStyle style{true, false, 54};
  CHECK(render_bar({"growth", "", 0.5}, style) == "growth                   [##########..........]  50 %");
  CHECK(render_bar({"growth", "", 1}, style) == "growth                   [####################] 100 %");
  CHECK_THAT(render_bar({"growth", "", 0.5}, {true, true, 54}), Contains("\x1b[36m"));
}

TEST_CASE("a bar shows what its step has found, and the time left") {
  const std::string bar = render_bar({"relaxation", "12/100, energy 0.0012", 0.5, 41.5}, {true, false, 80});
  CHECK_THAT(bar, Catch::Matchers::StartsWith("relaxation 12/100, energy 0.0012 [#"));
  CHECK_THAT(bar, Catch::Matchers::EndsWith("]  50 %  42 s left"));
}

TEST_CASE("without bars, a line of progress tells the same once in each interval") {
  CHECK(describe_progress({"sampling", "", 0.459, {}}) == "sampling: 45 %");
  CHECK(describe_progress({"relaxation", "12, energy 0.5", 0.5, 41.5}) ==
        "relaxation: 50 %, 12, energy 0.5, 42 s left");
  const auto printed = [](std::chrono::milliseconds interval, bool quiet) {
    return stderr_of([&] { Console("gvd-test", {false, false, 80, interval}, quiet, false).bar("sampling", 0.25); });
  };
  CHECK(printed(std::chrono::milliseconds(0), false) == "gvd-test: sampling: 25 %\n");
  CHECK(printed(std::chrono::milliseconds(0), true).empty());
  CHECK(printed(std::chrono::seconds(10), false).empty());
}

TEST_CASE("the time left is that of the part that is left") {
  TimeLeft left;
  CHECK(!left.update("a", 0, 100));
  CHECK(!left.update("a", 0.2, 100.5));  // the first second
  CHECK(!left.update("b", 0, 101));      // another step
  CHECK(!left.update("b", 0.001, 109));  // less than a hundredth
  CHECK(left.update("b", 0.5, 111) == Approx(10));
  CHECK(left.update("b", 0.75, 113) == Approx(4));
}

TEST_CASE("a step may go back a little, and is measured anew where it begins again") {
  TimeLeft left;
  left.update("a", 0, 0);
  CHECK(left.update("a", 0.5, 10) == Approx(10));
  CHECK(left.update("a", 0.45, 12) == Approx(12));
  CHECK(!left.update("a", 0, 13));
  CHECK(left.update("a", 0.5, 15) == Approx(2));
}

TEST_CASE("the time left has a unit that suits it") {
  CHECK(format_time_left(0.2) == "1 s left");
  CHECK(format_time_left(59) == "59 s left");
  CHECK(format_time_left(61) == "2 min left");
  CHECK(format_time_left(7200) == "2 h left");
  CHECK(format_time_left(1e30) == "999 h left");
}

}  // namespace gvd::test_console
