// Nearest faces, against the exact search of ClosestPointTree.
#include <cmath>

#include "distance/nearest_face.hpp"
#include "gvd/closest_point.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/random.hpp"
#include "support/tiny_meshes.hpp"

using namespace gvd;

TEST_CASE("nearest face: as a search by closest points, near the surface and far from it, from any guess") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    const NearestFaceTree fast(mesh);
    const ClosestPointTree slow(mesh);
    test::Random random(7);
    for (int round = 0; round < 200; ++round) {
      const double size = std::pow(10, random.real(-3, 1));
      const Vec3 point = mesh.position(VertexId(random.below(mesh.vertex_count()))) +
                         size * Vec3(random.real(-1, 1), random.real(-1, 1), random.real(-1, 1));
      const NearestFace found = fast.find(point, FaceId(random.below(mesh.face_count())));
      const double wanted = slow.query(point).distance;
      REQUIRE(found.distance == Approx(wanted).epsilon(1e-9).margin(1e-14));
      REQUIRE(closest_point_on_face(mesh, found.face, point).distance == Approx(wanted).epsilon(1e-9).margin(1e-14));
      const FaceId any(random.below(mesh.face_count()));
      REQUIRE(fast.distance(point, any) == Approx(closest_point_on_face(mesh, any, point).distance).epsilon(1e-9));
    }
  }
}

TEST_CASE("a face without area has the distance of its longest edge") {
  const NearestFaceTree line(test::make_mesh({{0, 0, 0}, {4, 0, 0}, {1, 0, 0}}, {{0, 1, 2}}));
  CHECK(line.distance({3, 2, 0}, FaceId(0)) == Approx(2));
  CHECK(line.find({-3, 4, 0}).distance == Approx(5));
  CHECK(line.find({7, 0, 4}).distance == Approx(5));
}
