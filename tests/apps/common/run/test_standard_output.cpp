#include <unistd.h>

#include <cstdio>
#include <functional>
#include <ostream>
#include <stdexcept>

#include "apps/run_command.hpp"
#include "common/run/interrupt.hpp"
#include "common/run/standard_output.hpp"
#include "support/catch.hpp"
#include "support/refusal.hpp"

namespace gvd::test_standard_output {

using namespace app;

/// Standard output leads to another file while this object lives.
class Redirected {
 public:
  explicit Redirected(int target) {
    std::fflush(stdout);
    saved_ = dup(STDOUT_FILENO);
    if (saved_ < 0 || dup2(target, STDOUT_FILENO) < 0) throw std::runtime_error("no redirection for the test");
    close(target);
  }
  ~Redirected() {
    // What could not be written is left in the buffer, and would come out now.
    std::FILE* const sink = std::fopen("/dev/null", "w");
    dup2(fileno(sink), STDOUT_FILENO);
    std::fflush(stdout);
    std::fclose(sink);
    dup2(saved_, STDOUT_FILENO);
    close(saved_);
    std::clearerr(stdout);
  }

 private:
  int saved_ = -1;
};

int open_file(const std::string& path) { return dup(fileno(std::fopen(path.c_str(), "w"))); }

void write_much(std::ostream& out) {
  for (int i = 0; i < 64; ++i) out << std::string(1 << 16, 'x');
}

TEST_CASE("standard output gets what is written, whole") {
  const test::ScratchFolder scratch;
  {
    const Redirected redirected(open_file(scratch / "a"));
    write_standard_output([](std::ostream& out) {
      out << "a" << 1;
      out.put('b');
    });
    write_standard_output(write_much);
  }
  CHECK(test::read_text(scratch / "a").substr(0, 4) == "a1bx");
  CHECK(test::read_text(scratch / "a").size() == 3 + (64u << 16));
}

TEST_CASE("a failed write has its reason, and a reader that is gone an exception of its own") {
  install_signal_handlers();
  {
    const Redirected redirected(open_file("/dev/full"));
    CHECK_THROWS_WITH(write_standard_output(write_much), Catch::Matchers::Contains("No space left"));
    CHECK_THROWS_AS(write_standard_output([](std::ostream& out) { out << "a"; }), Error);
  }
  int ends[2];
  REQUIRE(pipe(ends) == 0);
  close(ends[0]);
  const Redirected redirected(ends[1]);
  CHECK(test::refusal([] { write_standard_output(write_much); }, ErrorCode::reader_gone) ==
        "the reader of standard output is gone");
}

}  // namespace gvd::test_standard_output
