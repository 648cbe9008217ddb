#include <algorithm>
#include <vector>

#include "geodesic/windows/propagation/kd_cut.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_kd_cut {

void check_boxes(const std::vector<Vec3>& points) {
  for (const std::int32_t boxes : {1, 2, 3, 7, 64}) {
    INFO(boxes);
    const KdCut cut(points, boxes);
    std::vector<int> content(static_cast<std::size_t>(boxes), 0);
    std::size_t i = 0;
    for (const Vec3& p : points) ++content.at(static_cast<std::size_t>(cut.box(p, i++)));
    const double fair = static_cast<double>(points.size()) / boxes;
    CHECK(*std::min_element(content.begin(), content.end()) > 0.7 * fair);
    CHECK(*std::max_element(content.begin(), content.end()) < 1.3 * fair + 1);
  }
}

TEST_CASE("boxes hold about as many points each") {
  check_boxes(test::make_bumpy_sphere(4, 1).positions());
  // A grid, row by row: every 64th point would lie in its first column.
  std::vector<Vec3> grid;
  for (int i = 0; i < 4096 * 64; ++i) grid.emplace_back(100 * (i % 64), i / 64, 0);
  check_boxes(grid);
  // No coordinate tells these apart.
  check_boxes(std::vector<Vec3>(1000, Vec3(1, 2, 3)));
}

}  // namespace gvd::test_kd_cut
