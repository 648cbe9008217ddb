#pragma once

#include <cstdint>
#include <new>
#include <optional>
#include <string>

namespace gvd::app {

inline constexpr const char* kLessMemory = "simplify the mesh";

/// The process holds more memory than --max-memory allows.
class MemoryLimitPassed : public std::bad_alloc {
 public:
  explicit MemoryLimitPassed(std::int64_t in_use) : in_use_(in_use) {}
  std::int64_t in_use() const noexcept { return in_use_; }
  const char* what() const noexcept override { return "the limit of memory is passed"; }

 private:
  std::int64_t in_use_;
};

/// From now on a request for memory that passes the limit throws std::bad_alloc: see `limit_heap`. Nothing: no limit.
/// `advice`: what lets the run do with less, for messages.
void limit_memory(std::optional<std::int64_t> bytes, const std::string& advice = kLessMemory);

/// Throws MemoryLimitPassed where the resident memory is above the limit: what is not counted as heap counts here. Asks
/// the system at most twenty times a second.
void check_memory();

/// The message for std::bad_alloc: how much was in use and asked for, and what helps. `in_use` is that of
/// MemoryLimitPassed.
std::string describe_shortage(std::optional<std::int64_t> in_use = {});

/// "1.5 GiB".
std::string format_bytes(std::int64_t bytes);

}  // namespace gvd::app
