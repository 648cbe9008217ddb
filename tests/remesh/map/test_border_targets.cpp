// How the vertices of a path are spaced.
#include <algorithm>
#include <vector>

#include "map/map_steps.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/random.hpp"

namespace gvd::test_border_targets {

TEST_CASE("path spacing: lengths are those of the edges, summed") {
  const Mesh mesh = test::make_grid(2, 1);
  const std::vector<VertexId> path{VertexId(0), VertexId(1), VertexId(2)};
  const double first = (mesh.position(path[1]) - mesh.position(path[0])).norm();
  const double second = (mesh.position(path[2]) - mesh.position(path[1])).norm();
  CHECK(lengths_along(mesh, path) == std::vector<double>{0, first, first + second});
}

TEST_CASE("path spacing: without a share of even spacing, numbers are scaled only") {
  std::vector<double> values{0, 1, 4};
  scale_and_even(values, 2, 0);
  CHECK(values == std::vector<double>{0, 0.5, 2});
}

TEST_CASE("path spacing: with even spacing alone, the numbers do not count") {
  std::vector<double> values{0, 0, 0, 0, 4};
  scale_and_even(values, 2, 1);
  CHECK(values == std::vector<double>{0, 0.5, 1, 1.5, 2});
}

TEST_CASE("path spacing: numbers that coincide are taken apart by the share of even spacing") {
  std::vector<double> values{0, 1, 1, 2};
  scale_and_even(values, 3, 0.1);
  CHECK(values[2] - values[1] == Approx(0.1));
  CHECK(values[3] == 3);
}

TEST_CASE("path spacing: numbers ascend and end at the last one, bit by bit") {
  test::Random random(1);
  for (int trial = 0; trial < 2000; ++trial) {
    std::vector<double> values{0};
    for (int i = 0; i < 1 + trial % 7; ++i) values.push_back(values.back() + random.real(0, 1));
    const double last = random.real(0.1, 7);
    scale_and_even(values, last, 0.1);
    CHECK(values.front() == 0);
    CHECK(values.back() == last);
    CHECK(std::is_sorted(values.begin(), values.end()));
  }
}

}  // namespace gvd::test_border_targets
