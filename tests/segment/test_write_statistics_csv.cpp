#include <limits>
#include <sstream>

#include "gvd/region_statistics.hpp"
#include "support/catch.hpp"

namespace gvd::test_write_statistics_csv {

const std::string kHeader = "label,area,share,perimeter,radius,compactness,euler_characteristic,neighbours\r\n";

std::string to_csv(const IdVector<GeneratorId, RegionStatistics>& regions) {
  std::ostringstream out;
  write_statistics_csv(out, regions);
  return out.str();
}

TEST_CASE("statistics as CSV: without regions there is the header") { CHECK(to_csv({}) == kHeader); }

TEST_CASE("statistics as CSV: a line for each region, with the shortest numbers") {
  IdVector<GeneratorId, RegionStatistics> regions(2);
  regions[GeneratorId(0)] = {0.1, 1.0 / 3, 2, 1e-300, 0.5, 1, {{GeneratorId(1), 0.25}, {GeneratorId(7), 1.5}}};
  regions[GeneratorId(1)].compactness = std::numeric_limits<double>::infinity();
  CHECK(to_csv(regions) == kHeader + "0,0.1,0.3333333333333333,2,1e-300,0.5,1,1=0.25 7=1.5\r\n1,0,0,0,0,,0,\r\n");
}

}  // namespace gvd::test_write_statistics_csv
