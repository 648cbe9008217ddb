#include <map>
#include <vector>

#include "diagram/cell_shares.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace gvd::test_cell_shares {

TEST_CASE("no cell asked for: no share") { CHECK(CellShares().take().empty()); }

TEST_CASE("a share begins at zero, and is the same one when it is asked for again") {
  CellShares shares;
  CHECK(shares[GeneratorId(7)].euler_characteristic == 0);
  CHECK(shares[GeneratorId(7)].area == 0);
  shares[GeneratorId(7)].area += 2;
  shares[GeneratorId(3)].area += 1;
  shares[GeneratorId(7)].area += 2;
  const std::vector<CellShare> all = shares.take();
  REQUIRE(all.size() == 2);
  CHECK(all[0].generator == GeneratorId(7));
  CHECK(all[0].area == 4);
  CHECK(all[1].generator == GeneratorId(3));
  CHECK(all[1].area == 1);
}

TEST_CASE("many cells, in any order, sum up as in an ordered map, and come out in the order of insertion") {
  test::Random random(5);
  for (const int cells : {1, 2, 16, 17, 1000}) {
    CAPTURE(cells);
    CellShares shares;
    std::map<GeneratorId, int> expected;
    std::vector<GeneratorId> order;
    for (int i = 0; i < 5000; ++i) {
      const GeneratorId g(1000003 * random.below(cells));  // far apart
      if (++expected[g] == 1) order.push_back(g);
      ++shares[g].euler_characteristic;
    }
    const std::vector<CellShare> all = shares.take();
    REQUIRE(all.size() == order.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      REQUIRE(all[i].generator == order[i]);
      REQUIRE(all[i].euler_characteristic == expected[order[i]]);
    }
  }
}

}  // namespace gvd::test_cell_shares
