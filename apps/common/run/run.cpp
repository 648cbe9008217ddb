#include "common/run/run.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <fstream>
#include <string>

#include "common/memory/memory_limit.hpp"

namespace gvd::app {

/// A new process begins with the peak of the one that started it in ru_maxrss, on Linux; VmHWM is its own.
std::int64_t peak_memory_bytes() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    std::int64_t kibibytes = 0;
    if (word == "VmHWM:" && status >> kibibytes) return std::int64_t{1024} * kibibytes;
  }
  rusage usage{};
  if (::getrusage(RUSAGE_SELF, &usage) != 0) return 0;
#ifdef __APPLE__
  return usage.ru_maxrss;
#else
  return std::int64_t{1024} * usage.ru_maxrss;  // Linux counts in kibibytes
#endif
}

void limit_memory_of(const ComputeOptions& compute) {
  // The points of the bisectors are most of an exact diagram.
  const bool exact = compute.method == Method::exact;
  limit_memory(compute.max_memory,
               exact ? fmt::format("{}, or take a coarser --chord-tolerance", kLessMemory) : kLessMemory);
}

Run::Run(const std::string& command, Options options, Console& console)
    : options_(std::move(options)), console_(console), report_(command, options_) {}

Progress Run::progress() {
  return [this](std::string_view step, double fraction) {
    console_.bar(step, fraction);
    check_memory();
    return !interrupt_requested();
  };
}

void Run::report_time(std::string_view step, double milliseconds) {
  console_.clear_bar();
  console_.detail(fmt::format("{}: {:.1f} ms", step, milliseconds));
  report_.set_time(step, milliseconds);
}

Run::Stopwatch::Stopwatch(Run& run, std::string_view step) : run_(run), step_(step) {
  check_interrupt();
  check_memory();
  start_ = std::chrono::steady_clock::now();
}

Run::Stopwatch::~Stopwatch() {
  const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start_;
  run_.report_time(step_, taken.count());
}

}  // namespace gvd::app
