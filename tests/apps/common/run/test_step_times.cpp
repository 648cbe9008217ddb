#include <csignal>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "common/run/step_times.hpp"
#include "gvd/error.hpp"
#include "support/catch.hpp"

namespace gvd::test_step_times {

using namespace app;

nlohmann::ordered_json times_of(Run& run) {
  std::ostringstream out;
  run.report().write(out);
  return nlohmann::ordered_json::parse(out.str())["timings_ms"];
}

TEST_CASE("alternating steps are reported once each, as sums, in the order of their first starts") {
  install_signal_handlers();
  Console console("gvd-test", {}, true, false);
  Run run("gvd-test", {}, console);
  {
    StepTimes times(run);
    for (int round = 0; round < 3; ++round) {
      times.start("slow");
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      times.start("fast");
    }
    CHECK(times_of(run).empty());
  }
  const auto times = times_of(run);
  REQUIRE(times.size() == 2);
  CHECK(times.begin().key() == "slow");
  CHECK(times["slow"].get<double>() >= 15);
  CHECK(times.contains("fast"));
}

TEST_CASE("steps that never start are not reported, and none starts after a signal") {
  install_signal_handlers();
  Console console("gvd-test", {}, true, false);
  Run run("gvd-test", {}, console);
  { const StepTimes unused(run); }
  CHECK(times_of(run).empty());
  std::raise(SIGINT);
  CHECK_THROWS_AS(StepTimes(run), Error);
  install_signal_handlers();
}

}  // namespace gvd::test_step_times
