// The process of a command: signals, standard streams and memory.
//
// A signal only sets a flag, which the progress callback and the steps check, so that a run ends where it can clean up.
// While a run waits for input, there is nothing to clean up and nothing checks the flag, so the handler itself ends the
// process.
// --max-memory is the system's limit for data (setrlimit, RLIMIT_DATA). It holds for every allocation of every thread,
// in C++ or not, and costs nothing. Beyond the limit, malloc returns null and operator new throws std::bad_alloc. The
// system counts the 8 MiB that a thread's stack reserves and not what it uses, so these reserves are added to the
// limit.

#include "common/process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <pthread.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>  // defines __GLIBC__
#include <filesystem>
#include <fstream>
#include <iostream>
#include <thread>

#include "common/outcome.hpp"
#include "gvd/error.hpp"
#include "gvd/io/write_file.hpp"
#include "gvd/text.hpp"

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace gvd::app {
namespace {

volatile std::sig_atomic_t interrupted = 0;

constexpr const char* kInterruptedMessage = "interrupted; no file is left half-written";

/// The line to print if a signal ends the process while it waits for input. It is made in advance, because a signal
/// handler must not allocate.
std::string g_interrupted_line;
volatile std::sig_atomic_t waiting = 0;

extern "C" void raise_flag(int) {
  interrupted = 1;
  if (waiting == 0) return;
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, g_interrupted_line.data(), g_interrupted_line.size());
  ::_exit(kInterrupted);
}

/// The bytes that the stacks of oneTBB's threads reserve, one thread for each core.
rlim_t stack_bytes() {
  pthread_attr_t attributes;
  std::size_t size = 0;
  if (::pthread_attr_init(&attributes) != 0) return 0;
  ::pthread_attr_getstacksize(&attributes, &size);
  ::pthread_attr_destroy(&attributes);
  return size * std::thread::hardware_concurrency();
}

}  // namespace

void install_signal_handlers() {
  interrupted = 0;
  struct sigaction once {};
  once.sa_handler = raise_flag;
  once.sa_flags = static_cast<int>(SA_RESETHAND);
  sigemptyset(&once.sa_mask);
  sigaction(SIGINT, &once, nullptr);
  sigaction(SIGTERM, &once, nullptr);
  struct sigaction ignore {};
  ignore.sa_handler = SIG_IGN;
  sigaction(SIGPIPE, &ignore, nullptr);
  sigaction(SIGXFSZ, &ignore, nullptr);
}

bool interrupt_requested() noexcept { return interrupted != 0; }

void check_interrupt() {
  if (interrupt_requested()) throw Error(ErrorCode::interrupted, kInterruptedMessage);
}

void set_command_name(const std::string& command) {
  g_interrupted_line = fmt::format("{}: error: {}\n", command, kInterruptedMessage);
}

WaitForInput::WaitForInput(const std::string& file) {
  std::error_code ignored;
  if (file != "-" && std::filesystem::is_regular_file(file, ignored)) return;
  waiting = 1;
  // An earlier signal has only set the flag.
  if (interrupt_requested()) {
    waiting = 0;
    check_interrupt();
  }
}

WaitForInput::~WaitForInput() { waiting = 0; }

void reserve_standard_streams() {
  // open() takes the lowest free number. Opened in the wrong direction, reads and writes fail as on a closed stream.
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) != -1 || errno != EBADF) continue;
    if (::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY) < 0) return;
  }
}

std::string read_standard_input() {
  const WaitForInput wait("-");
  std::string bytes = read_to_end(std::cin);
  check_interrupt();
  if (std::cin.bad()) {
    throw Error(ErrorCode::unreadable_input, std::string(kStandardInput) + ": could not be read to its end");
  }
  return bytes;
}

void write_standard_output(const std::function<void(std::ostream&)>& write) {
  write_open_file(stdout, "standard output", write);
}

int end_by_broken_pipe() {
  std::signal(SIGPIPE, SIG_DFL);
  std::raise(SIGPIPE);
  return kReaderGone;
}

void keep_freed_memory() noexcept {
#ifdef __GLIBC__
  // Setting one of the two disables glibc's own choice of the other. With 32-bit pointers, the first one is refused.
  if (mallopt(M_MMAP_THRESHOLD, kKeptFreedBytes) == 1) mallopt(M_TRIM_THRESHOLD, kKeptFreedBytes);
#endif
}

void release_freed_memory() noexcept {
#ifdef __GLIBC__
  if (mallinfo2().fordblks > kWorthReleasing) malloc_trim(0);
#endif
}

void limit_memory(std::optional<std::int64_t> bytes) {
  static const rlimit kInitial = [] {
    rlimit limit{RLIM_INFINITY, RLIM_INFINITY};
    ::getrlimit(RLIMIT_DATA, &limit);
    return limit;
  }();
  rlimit limit = kInitial;
  if (bytes) limit.rlim_cur = std::min(limit.rlim_cur, static_cast<rlim_t>(*bytes) + stack_bytes());
  ::setrlimit(RLIMIT_DATA, &limit);
}

std::int64_t peak_memory_bytes() {
  // On Linux, ru_maxrss of a new process starts with the peak of its parent; VmHWM is the process's own.
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    std::int64_t kibibytes = 0;
    if (word == "VmHWM:" && status >> kibibytes) return std::int64_t{1024} * kibibytes;
  }
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;  // in bytes on macOS
}

}  // namespace gvd::app
