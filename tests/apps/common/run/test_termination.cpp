#include <unistd.h>

#include <functional>
#include <new>
#include <stdexcept>
#include <thread>

#include "apps/run_command.hpp"
#include "common/memory/heap_count.hpp"
#include "common/memory/memory_limit.hpp"
#include "common/run/child_process.hpp"
#include "common/run/termination.hpp"
#include "support/catch.hpp"

namespace gvd::test_termination {

using namespace app;
using namespace test;
using Catch::Matchers::Contains;

struct Ended {
  ChildEnd end;
  std::string err;
};

/// Runs `work`, which is to call std::terminate, in a process of its own.
Ended terminate_in(const std::function<void()>& work, const std::string& input = "") {
  const ScratchFolder scratch;
  const std::string err = scratch / "err";
  const ChildEnd end = run_in_child([&](std::string&) {
    if (std::freopen(err.c_str(), "w", stderr) == nullptr) return 1;
    limit_memory({});
    report_termination("gvd-test", input);
    work();
    return 0;
  });
  return {end, read_text(err)};
}

void throw_in_destructor(const std::function<void()>& fail) {
  struct Guard {
    const std::function<void()>& fail;
    ~Guard() { fail(); }
  };
  const Guard guard{fail};
}

TEST_CASE("an exception that nothing may catch ends the process with one line and an exit code") {
  const Ended memory = terminate_in([] { throw_in_destructor([] { throw std::bad_alloc(); }); });
  CHECK(memory.end.exit_code == 5);
  CHECK(memory.end.signal == 0);
  CHECK(memory.err == "gvd-test: error: out of memory; simplify the mesh; --max-memory ends such a run sooner\n");
  const Ended other = terminate_in([] { throw_in_destructor([] { throw std::runtime_error("x"); }); });
  CHECK(other.end.exit_code == 5);
  CHECK(other.err == "gvd-test: error: unexpected: x; please report it\n");
}

TEST_CASE("std::terminate without an exception, and in another thread, has its line too") {
  CHECK(terminate_in([] { std::terminate(); }).err ==
        "gvd-test: error: unexpected: ended without an exception; please report it\n");
  const Ended thread = terminate_in([] { std::thread([] { throw std::bad_alloc(); }).join(); });
  CHECK(thread.end.exit_code == 5);
  CHECK_THAT(thread.err, Contains("gvd-test: error: out of memory"));
}

TEST_CASE("of several inputs the line names the one") {
  CHECK(terminate_in([] { std::terminate(); }, "a.obj").err ==
        "gvd-test: error: a.obj: unexpected: ended without an exception; please report it\n");
}

TEST_CASE("a request that was refused is in the line") {
  if (heap_bytes() == 0) return;  // sanitizers end the process themselves
  const Ended ended = terminate_in([] {
    limit_memory(1 << 20);
    throw_in_destructor([] { ::operator delete(::operator new (std::size_t{1} << 40)); });
  });
  CHECK(ended.end.exit_code == 5);
  CHECK_THAT(ended.err, Contains("out of memory") && Contains("beyond --max-memory 1 MiB"));
}

}  // namespace gvd::test_termination
