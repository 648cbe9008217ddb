#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>

// The process of a command: signals, standard streams and memory.
namespace gvd::app {

/// From now on the first SIGINT or SIGTERM only sets a flag; the second one ends the process. A write to a closed pipe,
/// or beyond the largest file that is allowed, becomes an error instead of a signal. Clears the flag.
void install_signal_handlers();

/// Set while an input is read that may never come, such as a pipe or a terminal: a signal then ends the process at
/// once, with the line `message` on standard error and the exit code of an interrupt. Nothing is written meanwhile, so
/// nothing is lost. A flag alone would not do: the C++ library begins an interrupted read again.
class WaitForInput {
 public:
  /// `file`: what is read; "-" is standard input. Does nothing for a regular file, whose reading ends by itself.
  explicit WaitForInput(const std::string& file);
  ~WaitForInput();
  WaitForInput(const WaitForInput&) = delete;
  WaitForInput& operator=(const WaitForInput&) = delete;
};

/// The name that begins the line of an interrupted wait: "gvd-segment".
void set_command_name(const std::string& command);

/// Whether the flag is set.
bool interrupt_requested() noexcept;

/// Throws Error{interrupted} where the flag is set. For steps without progress.
void check_interrupt();

/// Opens /dev/null in place of closed standard streams: the next file that is opened would get their numbers, and with
/// them the messages. Writing to a closed stream stays an error.
void reserve_standard_streams();

/// The name of standard input in messages.
inline constexpr const char* kStandardInput = "standard input";

/// All that standard input holds. Throws Error{unreadable_input}, and Error{interrupted} after a signal.
std::string read_standard_input();

/// Writes to standard output what `write` puts into its stream, and flushes it.
/// Throws out of the first write that fails: Error{reader_gone}, or Error{unwritable_output} with the reason.
void write_standard_output(const std::function<void(std::ostream&)>& write);

/// Ends the process by SIGPIPE, as it would have ended had the signal not been ignored. Returns the exit code that
/// stands for it, 141, where the signal is blocked.
int end_by_broken_pipe();

/// Bytes. The largest size from which glibc takes blocks from the system (HEAP_MAX_SIZE / 2, with 64 bits).
inline constexpr int kKeptFreedBytes = 32 << 20;

/// Lets each arena of glibc keep up to kKeptFreedBytes that were freed at its end, and serve requests below that from
/// them. A relaxation allocates and frees the same tens of megabytes in each iteration; by default glibc returns them,
/// and the system clears each page again. Overrides MALLOC_TRIM_THRESHOLD_, MALLOC_MMAP_THRESHOLD_ and GLIBC_TUNABLES.
/// Does nothing with other C libraries.
void keep_freed_memory() noexcept;

/// Bytes that are worth the time of returning them, and of clearing pages again: beyond meshes of 100,000 faces.
inline constexpr std::size_t kWorthReleasing = std::size_t{1} << 26;

/// Returns freed memory to the system, also between blocks that are in use, where that is much. Does nothing with other
/// C libraries.
void release_freed_memory() noexcept;

/// Limits the heap and the static data of the process (RLIMIT_DATA): a request beyond the limit throws std::bad_alloc.
/// Nothing: the limit that the process began with. Sanitizers reserve more than any limit.
void limit_memory(std::optional<std::int64_t> bytes);

/// Largest resident memory of the process so far, in bytes.
std::int64_t peak_memory_bytes();

}  // namespace gvd::app
