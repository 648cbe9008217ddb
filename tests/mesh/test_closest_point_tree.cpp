// Nearest faces for measurements, against the exact search.
#include <cmath>

#include "gvd/closest_point.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/random.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_closest_point_tree {

TEST_CASE("nearest face: as a search by closest points, near the surface and far from it, from any guess") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    const ClosestPointTree tree(mesh);
    test::Random random(7);
    for (int round = 0; round < 200; ++round) {
      const double size = std::pow(10, random.real(-3, 1));
      const Vec3 point = mesh.position(VertexId(random.below(mesh.vertex_count()))) +
                         size * Vec3(random.real(-1, 1), random.real(-1, 1), random.real(-1, 1));
      const NearestFace found = tree.nearest_face(point, FaceId(random.below(mesh.face_count())));
      const double wanted = tree.query(point).distance;
      REQUIRE(found.distance == Approx(wanted).epsilon(1e-9).margin(1e-14));
      REQUIRE(closest_point_on_face(mesh, found.face, point).distance == Approx(wanted).epsilon(1e-9).margin(1e-14));
      const FaceId any(random.below(mesh.face_count()));
      REQUIRE(tree.distance(point, any) == Approx(closest_point_on_face(mesh, any, point).distance).epsilon(1e-9));
    }
  }
}

TEST_CASE("a face without area has the distance of its longest edge") {
  const Mesh mesh = test::make_mesh({{0, 0, 0}, {4, 0, 0}, {1, 0, 0}}, {{0, 1, 2}});
  const ClosestPointTree line(mesh);
  CHECK(line.distance({3, 2, 0}, FaceId(0)) == Approx(2));
  CHECK(line.nearest_face({-3, 4, 0}).distance == Approx(5));
  CHECK(line.nearest_face({7, 0, 4}).distance == Approx(5));
}

}  // namespace gvd::test_closest_point_tree
