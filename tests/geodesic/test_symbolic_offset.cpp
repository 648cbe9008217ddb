#include "geodesic/symbolic_offset.hpp"
#include "support/catch.hpp"

namespace gvd::test_symbolic_offset {

TEST_CASE("without a step no generator has an offset, not even none") {
  const SymbolicOffset none;
  for (const int g : {-1, 0, 1, 1000000}) CHECK(none.of(GeneratorId(g)) == 0);
}

TEST_CASE("(1) offsets grow with the generator's id by one step") {
  for (const auto& offset : {SymbolicOffset::of_marching(2, 1000), SymbolicOffset::of_envelope(2, 1000)}) {
    REQUIRE(offset.step > 0);
    for (int g = 1; g < 1000; ++g) {
      REQUIRE(offset.of(GeneratorId(g)) > offset.of(GeneratorId(g - 1)));
      REQUIRE(offset.of(GeneratorId(g)) - offset.of(GeneratorId(g - 1)) == Approx(offset.step).epsilon(1e-9));
    }
  }
}

TEST_CASE("(2) no offset is above the scale, for one generator and for a million") {
  for (const std::size_t count : {std::size_t{1}, std::size_t{3}, std::size_t{1000000}}) {
    const GeneratorId last(static_cast<std::int64_t>(count) - 1);
    CHECK(SymbolicOffset::of_marching(0.5, count).of(last) == Approx(0.5e-9).epsilon(1e-12));
    CHECK(SymbolicOffset::of_envelope(8, count).of(last) <= 8e-13);
  }
}

TEST_CASE("marched offsets begin at one step, those of an envelope at 0") {
  const auto marching = SymbolicOffset::of_marching(1, 10), envelope = SymbolicOffset::of_envelope(1, 10);
  CHECK(marching.of(GeneratorId(0)) == marching.step);
  CHECK(envelope.of(GeneratorId(0)) == 0);
}

}  // namespace gvd::test_symbolic_offset
