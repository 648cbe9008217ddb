#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>

// The process of a command: signals, standard streams and memory.
namespace gvd::app {

/// From now on, the first SIGINT or SIGTERM only sets a flag, and the second one ends the process. Writing to a closed
/// pipe, or beyond the largest allowed file size, fails with an error instead of a signal. Clears the flag.
void install_signal_handlers();

/// Exists while the process reads input that may never come, such as a pipe or a terminal. A signal then ends the
/// process at once, with a line on standard error and the exit code of an interrupt. Nothing is lost, because nothing
/// is written meanwhile. The flag alone would not suffice, because the C++ library restarts an interrupted read.
class WaitForInput {
 public:
  /// `file` is the file to read, or "-" for standard input. Does nothing for a regular file, because reading it always
  /// ends.
  explicit WaitForInput(const std::string& file);
  ~WaitForInput();
  WaitForInput(const WaitForInput&) = delete;
  WaitForInput& operator=(const WaitForInput&) = delete;
};

/// Sets the name with which the line of an interrupted wait begins, such as "gvd-segment".
void set_command_name(const std::string& command);

/// Whether the flag is set.
bool interrupt_requested() noexcept;

/// Throws Error{interrupted} if the flag is set. For steps that report no progress.
void check_interrupt();

/// Opens /dev/null in place of closed standard streams. Otherwise the next opened file would get their number, and
/// messages would go into it. Writing to a closed stream is still an error.
void reserve_standard_streams();

/// The name of standard input in messages.
inline constexpr const char* kStandardInput = "standard input";

/// Reads standard input to its end. Throws Error{unreadable_input}, and Error{interrupted} after a signal.
std::string read_standard_input();

/// Calls `write` with a stream to standard output, and flushes it. The first write that fails throws
/// Error{reader_gone}, or Error{unwritable_output} with the reason.
void write_standard_output(const std::function<void(std::ostream&)>& write);

/// Ends the process by SIGPIPE, as if the signal had not been ignored. If the signal is blocked, returns the exit code
/// that stands for it, 141.
int end_by_broken_pipe();

/// In bytes. The largest threshold above which glibc takes blocks directly from the system (HEAP_MAX_SIZE / 2, with 64
/// bits).
inline constexpr int kKeptFreedBytes = 32 << 20;

/// Lets each arena of glibc keep up to kKeptFreedBytes of freed memory at its end, and serve smaller requests from it.
/// A relaxation allocates and frees the same tens of megabytes in each iteration; by default glibc would return them,
/// and the system would clear each page again. Overrides MALLOC_TRIM_THRESHOLD_, MALLOC_MMAP_THRESHOLD_ and
/// GLIBC_TUNABLES. Does nothing with other C libraries.
void keep_freed_memory() noexcept;

/// The number of bytes from which returning memory is worth the time, including the time to clear pages again. Meshes
/// of more than 100,000 faces reach it.
inline constexpr std::size_t kWorthReleasing = std::size_t{1} << 26;

/// Returns freed memory to the system, including memory between blocks in use, if it is much. Does nothing with other C
/// libraries than glibc.
void release_freed_memory() noexcept;

/// Limits the heap and the static data of the process (RLIMIT_DATA): an allocation beyond the limit throws
/// std::bad_alloc. Without a value, restores the limit with which the process began. It can't be used with sanitizers,
/// which reserve more than any limit.
void limit_memory(std::optional<std::int64_t> bytes);

/// Largest resident memory of the process so far, in bytes.
std::int64_t peak_memory_bytes();

}  // namespace gvd::app
