// The segments of bisectors, sorted by their cells.
#include <algorithm>
#include <utility>
#include <vector>

#include "measured_cells.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace gvd::test_cell_sums {

std::pair<GeneratorId, GeneratorId> cells_of(const BisectorSegment& segment) { return {segment.left, segment.right}; }

/// Between random cells below `cells`; their lengths are their places.
std::vector<BisectorSegment> random_segments(int count, int cells, unsigned seed) {
  test::Random random(seed);
  std::vector<BisectorSegment> segments;
  for (int i = 0; i < count; ++i) {
    const auto left = static_cast<std::int64_t>(random.real(0, cells - 1.001));
    const auto right = static_cast<std::int64_t>(random.real(static_cast<double>(left) + 1, cells));
    segments.push_back({GeneratorId(left), GeneratorId(right), double(i)});
  }
  return segments;
}

TEST_CASE("bisector segments: sorted by their cells, those of the same cells as before") {
  for (const int count : {0, 1, 2, 300}) {
    for (const int cells : {2, 3, 40}) {
      CAPTURE(count, cells);
      std::vector<BisectorSegment> segments = random_segments(count, cells, 1);
      std::vector<BisectorSegment> expected = segments;
      std::stable_sort(expected.begin(), expected.end(),
                       [](const auto& a, const auto& b) { return cells_of(a) < cells_of(b); });
      sort_by_cells(segments);
      REQUIRE(segments.size() == expected.size());
      for (std::size_t i = 0; i < segments.size(); ++i) {
        CHECK(cells_of(segments[i]) == cells_of(expected[i]));
        CHECK(segments[i].length == expected[i].length);
      }
      const auto pairs = neighbouring_cells(segments);
      CHECK(std::is_sorted(pairs.begin(), pairs.end()));
      CHECK(std::adjacent_find(pairs.begin(), pairs.end()) == pairs.end());
    }
  }
}

}  // namespace gvd::test_cell_sums
