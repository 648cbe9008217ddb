#include <csignal>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "common/process.hpp"
#include "common/run.hpp"
#include "gvd/error.hpp"
#include "support/catch.hpp"

namespace gvd::test_run {

using namespace app;

nlohmann::json report_of(Run& run) {
  std::ostringstream out;
  run.report().write(out);
  return nlohmann::json::parse(out.str());
}

struct Fixture {
  Console console{"gvd-test", {}, true, false};
  Run run{"gvd-test", {}, console};
};

TEST_CASE("a timed step returns its result, and its time is reported unless it throws") {
  install_signal_handlers();
  Fixture fixture;
  CHECK(fixture.run.timed("first", [] { return 7; }) == 7);
  CHECK_THROWS_AS(fixture.run.timed("second", [] { throw std::bad_alloc(); }), std::bad_alloc);
  fixture.run.report_time("third", 12.5);
  const auto times = report_of(fixture.run)["timings_ms"];
  CHECK(times.size() == 2);
  CHECK(times.contains("first"));
  CHECK(times["third"] == 12.5);
}

TEST_CASE("after a signal no step starts, and progress cancels") {
  install_signal_handlers();
  Fixture fixture;
  CHECK(fixture.run.progress()("work", 0.5));
  std::raise(SIGINT);
  CHECK(!fixture.run.progress()("work", 0.5));
  CHECK_THROWS_AS(fixture.run.timed("step", [] { FAIL("it started"); }), Error);
  CHECK(report_of(fixture.run)["timings_ms"].empty());
  install_signal_handlers();
}

nlohmann::ordered_json step_times_of(Run& run) {
  std::ostringstream out;
  run.report().write(out);
  return nlohmann::ordered_json::parse(out.str())["timings_ms"];
}

TEST_CASE("steps that begin again are reported as sums in the end, in the order of their first starts") {
  install_signal_handlers();
  Console console("gvd-test", {}, true, false);
  Run run("gvd-test", {}, console);
  {
    RunObserver observer(run);
    for (int round = 0; round < 3; ++round) {
      as_step(observer, "slow", [] { std::this_thread::sleep_for(std::chrono::milliseconds(5)); });
      as_step(observer, "fast", [] {});
    }
    CHECK(step_times_of(run)["slow"].get<double>() >= 5);
  }
  const auto times = step_times_of(run);
  REQUIRE(times.size() == 2);
  CHECK(times.begin().key() == "slow");
  CHECK(times["slow"].get<double>() >= 15);
  CHECK(times.contains("fast"));
}

}  // namespace gvd::test_run
