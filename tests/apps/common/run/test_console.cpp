#include "common/run/console.hpp"
#include "support/catch.hpp"

namespace gvd::test_console {

using namespace app;
using Catch::Matchers::Contains;

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

}  // namespace gvd::test_console
