#include "common/run/console.hpp"
#include "support/catch.hpp"

using namespace gvd::app;

TEST_CASE("a bar fits its terminal") {
  for (int width = 1; width < 200; ++width) {
    for (const double fraction : {-1.0, 0.0, 0.333, 1.0, 2.0}) {
      const std::string bar = render_bar("a step with a rather long name", fraction, {true, false, width});
      CAPTURE(width, fraction, bar);
      CHECK(static_cast<int>(bar.size()) <= std::max(6, width - 1));
      CHECK(bar.find('\n') == std::string::npos);
    }
  }
}

TEST_CASE("a bar shows its part") {
  const ConsoleStyle style{true, false, 54};
  CHECK(render_bar("growth", 0.5, style) == "growth                   [##########..........]  50 %");
  CHECK(render_bar("growth", 1, style) == "growth                   [####################] 100 %");
  CHECK(render_bar("growth", 0.5, {true, true, 54}).find("\x1b[36m") != std::string::npos);
}
