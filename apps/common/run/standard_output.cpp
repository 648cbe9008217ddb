#include "common/run/standard_output.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <ostream>
#include <streambuf>
#include <string>
#include <system_error>

#include "gvd/error.hpp"

namespace gvd::app {
namespace {

[[noreturn]] void fail(int error) {
  if (error == EPIPE) throw ReaderGone();
  throw Error(ErrorCode::unwritable_output,
              "standard output: could not be written: " + std::generic_category().message(error));
}

/// std::cout keeps no reason for its failure, and writers go on after it.
class OutputBuffer : public std::streambuf {
 protected:
  std::streamsize xsputn(const char* bytes, std::streamsize count) override {
    const auto size = static_cast<std::size_t>(count);
    if (std::fwrite(bytes, 1, size, stdout) != size) fail(errno);
    return count;
  }

  int_type overflow(int_type c) override {
    if (traits_type::eq_int_type(c, traits_type::eof())) return traits_type::not_eof(c);
    const char byte = traits_type::to_char_type(c);
    xsputn(&byte, 1);
    return c;
  }

  int sync() override {
    if (std::fflush(stdout) != 0) fail(errno);
    return 0;
  }
};

}  // namespace

void write_standard_output(const std::function<void(std::ostream&)>& write) {
  OutputBuffer buffer;
  std::ostream stream(&buffer);
  stream.exceptions(std::ios::badbit);  // lets the buffer's own exception through
  write(stream);
  stream.flush();
}

int end_by_broken_pipe() {
  std::signal(SIGPIPE, SIG_DFL);
  std::raise(SIGPIPE);
  constexpr int kSignalled = 128;  // what shells add
  return kSignalled + SIGPIPE;
}

void reserve_standard_streams() {
  // open() takes the lowest free number. The wrong direction lets writes and reads fail as on the closed stream.
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) != -1 || errno != EBADF) continue;
    if (::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY) < 0) return;
  }
}

}  // namespace gvd::app
