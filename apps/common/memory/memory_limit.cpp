#include "common/memory/memory_limit.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <fstream>

#include "common/memory/heap_count.hpp"

namespace gvd::app {
namespace {

constexpr std::chrono::milliseconds kInterval{50};

struct State {
  std::optional<std::int64_t> limit;
  std::string advice = kLessMemory;
  std::chrono::steady_clock::time_point next_look{};
};

State& state() {
  static State only;
  return only;
}

/// Nothing where the system does not tell.
std::optional<std::int64_t> resident_bytes() {
  std::ifstream pages("/proc/self/statm");
  std::int64_t total = 0, resident = 0;
  if (!(pages >> total >> resident)) return std::nullopt;
  return resident * ::sysconf(_SC_PAGESIZE);
}

}  // namespace

void limit_memory(std::optional<std::int64_t> bytes, const std::string& advice) {
  state() = {bytes, advice, {}};
  limit_heap(bytes);
}

void check_memory() {
  State& now = state();
  if (!now.limit || std::chrono::steady_clock::now() < now.next_look) return;
  now.next_look = std::chrono::steady_clock::now() + kInterval;
  const auto resident = resident_bytes();
  if (resident && *resident > *now.limit) throw MemoryLimitPassed(*resident);
}

std::string describe_shortage(std::optional<std::int64_t> in_use) {
  const auto& [limit, advice, next_look] = state();
  std::string needed = "out of memory";
  if (const auto refused = refused_request()) {
    needed = fmt::format("out of memory: {} in use, and {} more asked for", format_bytes(refused->in_use),
                         format_bytes(refused->size));
  } else if (in_use) {
    needed = fmt::format("out of memory: {} in use", format_bytes(*in_use));
  }
  if (limit) return fmt::format("{}, beyond --max-memory {}; raise it, {}", needed, format_bytes(*limit), advice);
  return fmt::format("{}; {}; --max-memory ends such a run sooner", needed, advice);
}

std::string format_bytes(std::int64_t bytes) {
  constexpr std::array<const char*, 5> kUnits{"bytes", "KiB", "MiB", "GiB", "TiB"};
  auto amount = static_cast<double>(bytes);
  std::size_t unit = 0;
  for (; amount >= 1024 && unit + 1 < kUnits.size(); ++unit) amount /= 1024;
  return unit == 0 || amount >= 100 ? fmt::format("{:.0f} {}", amount, kUnits[unit])
                                    : fmt::format("{:.3g} {}", amount, kUnits[unit]);
}

}  // namespace gvd::app
