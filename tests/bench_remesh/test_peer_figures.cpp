#include "peer_figures.hpp"
#include "support/catch.hpp"

namespace gvd::test_peer_figures {

using namespace bench;

TEST_CASE("a figure is compared with the best of the peers") {
  const PeerRow distance{"distance", true, {3, 2, std::nullopt}}, quality{"quality", false, {0.5, 0.25, 0.75}};
  CHECK(compare_with_best(1.5, distance) == "ahead by 0.5");
  CHECK(compare_with_best(2, distance) == "level");
  CHECK(compare_with_best(2.5, distance) == "behind ACVDQ by 0.5");
  CHECK(compare_with_best(0.875, quality) == "ahead by 0.125");
  CHECK(compare_with_best(0.5, quality) == "behind Geogram by 0.25");
}

TEST_CASE("without a peer there is nothing to compare with") {
  CHECK(compare_with_best(1, PeerRow{"time", true, {}}).empty());
  CHECK(peer_figures(300).empty());
}

TEST_CASE("the figures of the peers have the same rows for each number of vertices") {
  const auto rows = peer_figures(500);
  CHECK(rows.size() == 7);
  for (const int n : {100, 2000}) {
    const auto others = peer_figures(n);
    REQUIRE(others.size() == rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      CHECK(std::string(others[i].figure) == rows[i].figure);
      CHECK(others[i].smaller_is_better == rows[i].smaller_is_better);
    }
  }
}

}  // namespace gvd::test_peer_figures
