#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "diagram/envelope/edge_distances.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace gvd::test_edge_distances {

TEST_CASE("a generator without a source is infinitely far along an edge") {
  EdgeDistances distances;
  distances.build({{0, 1, 0, 0, 0, GeneratorId(0)}, {0, 1, 1, 0, 0, GeneratorId(2)}});
  CHECK(std::isinf(distances.at(GeneratorId(1), 0.5)));
  CHECK(std::isinf(distances.at(GeneratorId(3), 0.5)));
  CHECK(distances.at(GeneratorId(0), 0.25) == 0.25);
  CHECK(distances.at(GeneratorId(2), 0.25) == 0.75);
}

TEST_CASE("the distances along an edge are the least over the sources of a generator, in any order") {
  test::Random random(11);
  for (int round = 0; round < 500; ++round) {
    std::vector<EdgeSource> sources;
    for (int k = random.below(30); k >= 0; --k) {
      const double begin = random.real(0, 1), end = random.real(begin, 1);
      const double offset = random.below(2) * random.real(0, 0.5);
      sources.push_back({begin, end, random.real(-1, 2), random.real(0, 1), offset, GeneratorId(random.below(4))});
    }
    EdgeDistances distances;
    distances.build(sources);
    for (int g = 0; g < 4; ++g) {
      const double t = random.real(0, 1);
      double least = std::numeric_limits<double>::infinity();
      for (const EdgeSource& s : sources) {
        if (s.generator == GeneratorId(g)) least = std::min(least, s.distance(t));
      }
      INFO("round " << round);
      if (std::isinf(least)) {
        REQUIRE(std::isinf(distances.at(GeneratorId(g), t)));
      } else {
        REQUIRE(distances.at(GeneratorId(g), t) == Approx(least).epsilon(1e-15));
      }
    }
  }
}

}  // namespace gvd::test_edge_distances
