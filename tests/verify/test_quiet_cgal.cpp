// CGAL's messages while its failed checks are expected.
#include <CGAL/assertions.h>
#include <CGAL/assertions_behaviour.h>
#include <CGAL/exceptions.h>

#include <stdexcept>

#include "quiet_cgal.hpp"
#include "support/catch.hpp"

namespace gvd::test_quiet_cgal {

int errors = 0, warnings = 0;  // CGAL's handlers are plain functions

void count_error(const char*, const char*, const char*, int, const char*) { ++errors; }
void count_warning(const char*, const char*, const char*, int, const char*) { ++warnings; }

/// Counts CGAL's messages, and takes the handlers back at the end.
class CountingHandlers {
 public:
  CountingHandlers()
      : on_error_(CGAL::set_error_handler(count_error)), on_warning_(CGAL::set_warning_handler(count_warning)) {
    errors = warnings = 0;
  }
  ~CountingHandlers() {
    CGAL::set_error_handler(on_error_);
    CGAL::set_warning_handler(on_warning_);
  }
  CountingHandlers(const CountingHandlers&) = delete;
  CountingHandlers& operator=(const CountingHandlers&) = delete;

 private:
  CGAL::Failure_function on_error_, on_warning_;
};

void fail_checks() {
  CHECK_THROWS_AS(CGAL::precondition_fail("x > 0", "here.h", 1, ""), CGAL::Precondition_exception);
  CGAL::warning_fail("x > 0", "here.h", 2, "");
}

void check_that_messages_come() {
  const int errors_before = errors, warnings_before = warnings;
  fail_checks();
  CHECK(errors == errors_before + 1);
  CHECK(warnings == warnings_before + 1);
}

TEST_CASE("a failed check throws in silence, and with a message again afterwards") {
  const CountingHandlers handlers;
  check_that_messages_come();
  {
    const QuietCgal quiet;
    fail_checks();
    CHECK(errors == 1);
    CHECK(warnings == 1);
  }
  check_that_messages_come();
}

TEST_CASE("an exception brings the messages back, too") {
  const CountingHandlers handlers;
  const auto fail = [] {
    const QuietCgal quiet;
    throw std::runtime_error("while CGAL is quiet");
  };
  CHECK_THROWS_AS(fail(), std::runtime_error);
  check_that_messages_come();
  const auto fail_in_cgal = [] {
    const QuietCgal quiet;
    CGAL::assertion_fail("x > 0", "here.h", 3, "");
  };
  CHECK_THROWS_AS(fail_in_cgal(), CGAL::Assertion_exception);
  check_that_messages_come();
}

TEST_CASE("the end of an inner silence does not end the outer one") {
  const CountingHandlers handlers;
  {
    const QuietCgal outer;
    { const QuietCgal inner; }
    fail_checks();
    CHECK(errors == 0);
    CHECK(warnings == 0);
  }
  check_that_messages_come();
}

}  // namespace gvd::test_quiet_cgal
