#include "diagram/paper/midpoint_distances.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/stages.hpp"

namespace gvd::test_midpoint_distances {

TEST_CASE("the distance at an edge midpoint is the mean of those at the edge's ends, for every entry of the tables") {
  const Mesh mesh = test::make_sphere(2);
  const test::Stages stages(mesh, test::random_generators(mesh, 9, 1), Front::planar);
  const MidpointDistances midpoints(stages.table(), stages.mesh().face_count());
  std::size_t entries = 0;
  for (std::int32_t i = 0; i < stages.mesh().face_count(); ++i) {
    const FaceId f(i);
    stages.table().for_each(f, [&](const TableEntry& entry) {
      const auto middle = midpoints.find(f, entry.generator);
      REQUIRE(middle);
      const auto corner = stages.table().corner_distances(entry);
      for (std::size_t k = 0; k < 3; ++k) REQUIRE((*middle)[k] == 0.5 * (corner[k] + corner[(k + 1) % 3]));
      ++entries;
    });
  }
  CHECK(entries > static_cast<std::size_t>(mesh.face_count()));
  CHECK_FALSE(midpoints.find(FaceId(0), GeneratorId(9)));
}

}  // namespace gvd::test_midpoint_distances
