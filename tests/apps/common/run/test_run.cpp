#include <csignal>
#include <nlohmann/json.hpp>
#include <sstream>

#include "common/run/run.hpp"
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

TEST_CASE("a timed step returns its result, and its time is reported even where it throws") {
  install_signal_handlers();
  Fixture fixture;
  CHECK(fixture.run.timed("first", [] { return 7; }) == 7);
  CHECK_THROWS_AS(fixture.run.timed("second", [] { throw std::bad_alloc(); }), std::bad_alloc);
  fixture.run.report_time("third", 12.5);
  const auto times = report_of(fixture.run)["timings_ms"];
  CHECK(times.size() == 3);
  CHECK(times.contains("first"));
  CHECK(times.contains("second"));
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

TEST_CASE("the peak of memory is that of the process and never falls") {
  const std::int64_t before = peak_memory_bytes();
  CHECK(before > 1000000);
  const std::vector<char> large(std::size_t{64} << 20, 1);
  const volatile char* const kept = large.data();  // or the compiler may leave the memory out
  CHECK(kept[large.size() / 2] == 1);
  CHECK(peak_memory_bytes() >= before);
  CHECK(peak_memory_bytes() > static_cast<std::int64_t>(large.size()));
}

}  // namespace gvd::test_run
