#include <new>
#include <stdexcept>
#include <system_error>

#include "common/run/outcome.hpp"
#include "gvd/error.hpp"
#include "support/catch.hpp"

namespace gvd::test_outcome {

using namespace app;

TEST_CASE("work that returns is done, and what it throws becomes a code and a message") {
  CHECK(run_guarded([] {}).exit_code == 0);
  CHECK(run_guarded([] {}).message.empty());
  const Outcome refused = run_guarded([] { throw Error(ErrorCode::precondition, "too far; raise max_snap"); });
  CHECK(refused.exit_code == 4);
  CHECK(refused.message == "too far; raise --max-snap");
  const Outcome strange = run_guarded([] { throw std::runtime_error("x"); });
  CHECK(strange.exit_code == 5);
  CHECK(strange.message == "unexpected: x; please report it");
}

TEST_CASE("a thread that can't be started is told as such, with what helps") {
  const auto no_thread = [] {
    throw std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again));
  };
  const auto none_of_tbb = [] { throw std::runtime_error("pthread_create has failed: Resource unavailable"); };
  for (const std::function<void()>& work : {std::function<void()>(no_thread), std::function<void()>(none_of_tbb)}) {
    const Outcome outcome = run_guarded(work);
    CHECK(outcome.exit_code == 5);
    CHECK(outcome.summary == "no thread");
    CHECK_THAT(outcome.message, Catch::Matchers::StartsWith("a thread could not be started") &&
                                    Catch::Matchers::EndsWith("use --threads 1"));
  }
}

TEST_CASE("a reader that is gone ends without a message") {
  const Outcome gone = run_guarded([] { throw Error(ErrorCode::reader_gone, "gone"); });
  CHECK(gone.exit_code == kReaderGone);
  CHECK(gone.message.empty());
}

TEST_CASE("an outcome has its words") {
  CHECK(run_guarded([] {}).summary == "done");
  CHECK(run_guarded([] { throw Error(ErrorCode::unreadable_input, "x"); }).summary == "unreadable input");
  CHECK(run_guarded([] { throw std::bad_alloc(); }).summary == "out of memory");
}

}  // namespace gvd::test_outcome
