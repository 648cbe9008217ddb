#include "common/memory/heap_count.hpp"
#include "common/memory/memory_limit.hpp"
#include "support/catch.hpp"

namespace gvd::test_memory_limit {

using namespace app;
using Catch::Matchers::Contains;

struct LimitOff {
  ~LimitOff() { limit_memory({}); }
};

TEST_CASE("bytes are written with the unit that suits them") {
  CHECK(format_bytes(0) == "0 bytes");
  CHECK(format_bytes(1023) == "1023 bytes");
  CHECK(format_bytes(1536) == "1.5 KiB");
  CHECK(format_bytes(500LL << 20) == "500 MiB");
  CHECK(format_bytes(2LL << 30) == "2 GiB");
}

TEST_CASE("a process that is larger than its limit ends at the next look") {
  const LimitOff off;
  limit_memory(1 << 20);
  lift_heap_limit_here();
  CHECK_THROWS_AS(check_memory(), MemoryLimitPassed);
  limit_memory(std::int64_t{1} << 50);
  CHECK_NOTHROW(check_memory());
  limit_memory({});
  CHECK_NOTHROW(check_memory());
}

TEST_CASE("a shortage is described with what was in use and what helps") {
  const LimitOff off;
  limit_memory(std::int64_t{2} << 30);
  CHECK_THAT(describe_shortage(3LL << 30),
             Contains("out of memory: 3 GiB in use, beyond --max-memory 2 GiB; raise it"));
  limit_memory({});
  CHECK_THAT(describe_shortage(), Contains("--max-memory ends such a run sooner") && !Contains("generators"));
}

}  // namespace gvd::test_memory_limit
