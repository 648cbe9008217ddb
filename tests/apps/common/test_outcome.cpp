#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <new>
#include <stdexcept>
#include <system_error>
#include <thread>

#include "apps/run_command.hpp"
#include "common/options/options.hpp"
#include "common/outcome.hpp"
#include "gvd/diagram_options.hpp"
#include "gvd/error.hpp"
#include "gvd/soup.hpp"
#include "support/catch.hpp"

namespace gvd::test_outcome {

using namespace app;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;

TEST_CASE("work that returns is done, and what it throws becomes a code and a message") {
  CHECK(run_guarded([] {}).exit_code == 0);
  CHECK(run_guarded([] {}).message.empty());
  const Outcome refused = run_guarded([] { throw Error(ErrorCode::precondition, "too far; raise \1max_snap\2"); });
  CHECK(refused.exit_code == 4);
  CHECK(refused.message == "too far; raise max_snap");  // no options are known yet
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
    CHECK_THAT(outcome.message, StartsWith("a thread could not be started") && EndsWith("use --threads 1"));
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

TEST_CASE("bytes are written with the unit that suits them") {
  CHECK(format_bytes(0) == "0 bytes");
  CHECK(format_bytes(1023) == "1023 bytes");
  CHECK(format_bytes(1536) == "1.5 KiB");
  CHECK(format_bytes(500LL << 20) == "500 MiB");
  CHECK(format_bytes(2LL << 30) == "2 GiB");
}

TEST_CASE("a shortage is described with the limit and what helps") {
  const auto message = [](const Options& options) {
    return run_guarded([&] {
             limit_memory_of(options);
             throw std::bad_alloc();
           })
        .message;
  };
  DiagramOptions diagram;
  OptionList list;
  describe(list, diagram);
  const Given given;
  Options options;
  options.list = &list;
  options.given = &given;
  CHECK_THAT(message(options),
             StartsWith("out of memory: up to ") &&
                 EndsWith("; use a coarser --chord-tolerance, or a mesh with fewer or better-shaped triangles; "
                          "use --max-memory to stop such a run earlier"));
  diagram.method = Method::gbgvd;
  CHECK_THAT(
      message(options),
      EndsWith("use a mesh with fewer or better-shaped triangles; use --max-memory to stop such a run earlier") &&
          !Contains("generators"));
  options.compute.max_memory = std::int64_t{2} << 30;
  CHECK(
      message(options) ==
      "out of memory: the run needs more than --max-memory 2 GiB; raise it, or use a mesh with fewer or better-shaped "
      "triangles");
  limit_memory_of({});
}

struct Ended {
  int exit_code = -1;  ///< -1 where a signal ended it
  std::string err;
};

/// Runs `work`, which is to call std::terminate, in a process of its own.
Ended terminate_in(const std::function<void()>& work, const std::string& input = "") {
  const test::ScratchFolder scratch;
  const std::string err = scratch / "err";
  const pid_t child = ::fork();
  if (child == 0) {
    if (std::freopen(err.c_str(), "w", stderr) == nullptr) std::_Exit(1);
    limit_memory_of({});
    report_termination("gvd-test", input);
    work();
    std::_Exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, test::read_text(err)};
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
  CHECK(memory.exit_code == 5);
  CHECK_THAT(
      memory.err,
      StartsWith("gvd-test: error: out of memory: ") &&
          EndsWith(
              "; use a mesh with fewer or better-shaped triangles; use --max-memory to stop such a run earlier\n"));
  const Ended other = terminate_in([] { throw_in_destructor([] { throw std::runtime_error("x"); }); });
  CHECK(other.exit_code == 5);
  CHECK(other.err == "gvd-test: error: unexpected: x; please report it\n");
}

TEST_CASE("std::terminate without an exception, and in another thread, has its line too") {
  CHECK(terminate_in([] { std::terminate(); }).err ==
        "gvd-test: error: unexpected: ended without an exception; please report it\n");
  const Ended thread = terminate_in([] { std::thread([] { throw std::bad_alloc(); }).join(); });
  CHECK(thread.exit_code == 5);
  CHECK_THAT(thread.err, Contains("gvd-test: error: out of memory"));
}

TEST_CASE("of several inputs the line names the one") {
  CHECK(terminate_in([] { std::terminate(); }, "a.obj").err ==
        "gvd-test: error: a.obj: unexpected: ended without an exception; please report it\n");
}

/// A command with two options, which a test gives on the command line, or in a file.
struct Command : Options {
  bool refine = true;
  double snap = 1;
  OptionList described;
  Given names;
  Command() {
    described.option("refine", Flag{&refine}, {.help = "Keep what is there"});
    described.option("max_snap", Number{&snap}, {.help = "Largest distance"});
    list = &described;
    given = &names;
  }
  std::string message(const char* text) const {
    return run_guarded([&] { throw Error(ErrorCode::no_valid_result, text); }, this).message;
  }
};

TEST_CASE("a message spells options as the user of the command writes them") {
  Command command;
  CHECK(command.message("raise \1max_snap\2") == "raise --max-snap");
  CHECK(command.message("give \1max_snap=3\2") == "give --max-snap 3");
  CHECK(command.message("leave \1refine=false\2 out") == "leave --no-refine out");
  CHECK(command.message("leave \1?refine=false|max_snap\2 out") == "leave --no-refine or --max-snap out");
  command.names.add("refine", {.spelling = "--no-r", .place = ""});
  CHECK(command.message("leave \1?refine=false|max_snap\2 out") == "leave --no-r out");
}

TEST_CASE("a message spells options of a file as this does") {
  Command command;
  command.names.add("refine", {.spelling = "no-refine", .place = "a.toml:3"});
  command.names.add("max_snap", {.spelling = "max-snap", .place = "a.toml:4"});
  CHECK(command.message("leave \1?refine=false\2 out") == "leave no-refine = true out");
  CHECK(command.message("give \1max_snap=3\2") == "give max-snap = 3");
}

TEST_CASE("an error that tells where keeps its placeholders, its code and its element") {
  const Error error = Error(ErrorCode::precondition, "raise \1max_snap\2", 7).at("list:3");
  CHECK(std::string(error.what()) == "list:3: raise max_snap");
  CHECK(std::string(error.text()) == "list:3: raise \1max_snap\2");
  CHECK(error.code() == ErrorCode::precondition);
  CHECK(error.element() == 7);
}

}  // namespace gvd::test_outcome
