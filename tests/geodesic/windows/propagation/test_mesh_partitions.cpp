#include <algorithm>
#include <cstdint>
#include <vector>

#include "geodesic/windows/propagation/mesh_partitions.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_mesh_partitions {

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

TEST_CASE("every partition has vertex copies of its own") {
  for (const auto& [name, mesh] : test::small_family()) {
    for (const std::int32_t partition_faces : {1, 20, 150, 1 << 20}) {
      INFO(name << " in partitions of " << partition_faces);
      const FaceFrames before(mesh, ParallelChunks(1, {}));
      FaceFrames frames(mesh, ParallelChunks(1, {}));
      const MeshPartitions partitions(mesh, partition_faces, frames);
      IdVector<VertexCopyId, PartitionId> partition_of_copy(partitions.copy_count());
      for (std::int32_t i = 0; i < mesh.halfedge_count(); ++i) {
        const HalfedgeId h(i);
        const VertexCopyId copy = frames.frame[Mesh::face(h)].vertex[Mesh::corner(h)];
        REQUIRE(copy.index() < partitions.copy_count());
        REQUIRE(partitions.vertex(copy) == mesh.from(h));
        REQUIRE(frames.kind[copy] == before.kind[first_copy(mesh.from(h))]);
        PartitionId& partition = partition_of_copy[copy];
        REQUIRE((!partition.valid() || partition == partitions.of_halfedge(h)));
        partition = partitions.of_halfedge(h);
        if (const SharedCopyId shared = partitions.shared(copy); shared.valid()) {
          const auto copies = partitions.copies(shared);
          CHECK(copies.front().vertex == first_copy(mesh.from(h)));
          CHECK(std::any_of(copies.begin(), copies.end(),
                            [&](const auto& c) { return c.vertex == copy && c.partition == partition; }));
        }
      }
    }
  }
}

TEST_CASE("the number of partitions follows the number of faces, up to a bound") {
  const Mesh mesh = test::make_grid(20, 20);  // 800 faces
  const auto count = [&](std::int32_t partition_faces) {
    FaceFrames frames(mesh, ParallelChunks(1, {}));
    return MeshPartitions(mesh, partition_faces, frames).count();
  };
  CHECK(count(1) == MeshPartitions::kMaxPartitions);
  CHECK(count(100) == 8);
  CHECK(count(801) == 1);
}

}  // namespace gvd::test_mesh_partitions
