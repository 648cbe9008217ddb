#include "common/run/standard_output.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>

#include "common/run/exit_code.hpp"
#include "gvd/io/write_file.hpp"

namespace gvd::app {

void write_standard_output(const std::function<void(std::ostream&)>& write) {
  write_open_file(stdout, "standard output", write);
}

int end_by_broken_pipe() {
  std::signal(SIGPIPE, SIG_DFL);
  std::raise(SIGPIPE);
  return kReaderGone;
}

void reserve_standard_streams() {
  // open() takes the lowest free number. The wrong direction lets writes and reads fail as on the closed stream.
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) != -1 || errno != EBADF) continue;
    if (::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY) < 0) return;
  }
}

}  // namespace gvd::app
