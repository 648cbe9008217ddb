#include "common/run/child_process.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <system_error>

#include "common/run/exit_code.hpp"
#include "common/run/interrupt.hpp"
#include "gvd/error.hpp"

namespace gvd::app {
namespace {

/// Between two looks at whether this process was interrupted: a signal may come just before the wait begins.
constexpr int kMilliseconds = 100;

[[noreturn]] void refuse() {
  throw Error(ErrorCode::no_valid_result, fmt::format("no process could be started for this input: {}; run it alone",
                                                      std::generic_category().message(errno)));
}

/// No exception leaves it: the child would go on as its parent.
[[noreturn]] void run_child(const std::function<int(std::string&)>& work, int pipe, pid_t parent) noexcept {
#ifdef __linux__
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);  // nobody waits for the results of a call that was killed
#endif
  if (::getppid() != parent) std::_Exit(kInterrupted);  // it was killed before the line above
  std::string answer;
  const int exit_code = work(answer);
  for (std::size_t sent = 0; sent < answer.size();) {
    const ssize_t count = ::write(pipe, answer.data() + sent, answer.size() - sent);
    if (count < 0 && errno != EINTR) break;
    sent += count < 0 ? 0 : static_cast<std::size_t>(count);
  }
  std::_Exit(exit_code);  // what this process inherited is not its own to end
}

/// Reads until the child has closed its end of the pipe, at the latest by ending.
std::string collect_answer(pid_t child, int pipe) {
  std::string answer;
  bool passed_on = false;
  for (;;) {
    pollfd waited{pipe, POLLIN, 0};
    if (::poll(&waited, 1, kMilliseconds) > 0) {
      std::array<char, 256> buffer{};
      const ssize_t count = ::read(pipe, buffer.data(), buffer.size());
      if (count == 0 || (count < 0 && errno != EINTR)) return answer;
      answer.append(buffer.data(), count < 0 ? 0 : static_cast<std::size_t>(count));
    }
    if (passed_on || !interrupt_requested()) continue;
    ::kill(child, SIGTERM);
    passed_on = true;
  }
}

}  // namespace

ChildEnd run_in_child(const std::function<int(std::string& answer)>& work) {
  std::array<int, 2> pipe{};
  if (::pipe(pipe.data()) != 0) refuse();
  std::signal(SIGCHLD, SIG_DFL);  // where a caller ignores it, a child's end can't be waited for
  const pid_t parent = ::getpid();
  const pid_t child = ::fork();
  if (child == 0) {
    ::close(pipe[0]);
    run_child(work, pipe[1], parent);
  }
  ::close(pipe[1]);
  if (child < 0) {
    const int reason = errno;
    ::close(pipe[0]);
    errno = reason;
    refuse();
  }
  ChildEnd end;
  end.answer = collect_answer(child, pipe[0]);
  ::close(pipe[0]);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFSIGNALED(status)) end.signal = WTERMSIG(status);
  if (WIFEXITED(status)) end.exit_code = WEXITSTATUS(status);
  return end;
}

}  // namespace gvd::app
