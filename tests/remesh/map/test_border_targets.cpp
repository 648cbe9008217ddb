// The lengths along a path.
#include <vector>

#include "map/cell_map.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_border_targets {

TEST_CASE("lengths along a path are those of the edges, summed") {
  const Mesh mesh = test::make_grid(2, 1);
  const std::vector<VertexId> path{VertexId(0), VertexId(1), VertexId(2)};
  const double first = (mesh.position(path[1]) - mesh.position(path[0])).norm();
  const double second = (mesh.position(path[2]) - mesh.position(path[1])).norm();
  CHECK(lengths_along(mesh, path) == std::vector<double>{0, first, first + second});
}

}  // namespace gvd::test_border_targets
