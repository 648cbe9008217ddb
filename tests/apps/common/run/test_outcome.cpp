#include <new>
#include <stdexcept>

#include "common/run/outcome.hpp"
#include "gvd/error.hpp"
#include "support/catch.hpp"

using namespace gvd;
using namespace gvd::app;

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
