#include <random>

#include "gvd/closest_point.hpp"
#include "gvd/surface_point.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

using namespace gvd;

namespace {

double uniform(std::mt19937& random) { return double(random()) / double(std::mt19937::max()); }

SurfacePoint random_point(const Mesh& mesh, std::mt19937& random) {
  const FaceId face(static_cast<std::int64_t>(random() % static_cast<unsigned>(mesh.face_count())));
  const double u = uniform(random), v = uniform(random) * (1 - u);
  return make_surface_point(face, random() % 4 == 0 ? std::array{u, 1 - u, 0.0} : std::array{u, v, 1 - u - v});
}

}  // namespace

TEST_CASE("the closest point is that of the best face") {
  std::mt19937 random(11);
  for (const auto& [name, mesh] : test::small_family()) {
    CAPTURE(name);
    const ClosestPointTree tree(mesh);
    for (int i = 0; i < 60; ++i) {
      const Vec3 query(4 * uniform(random) - 2, 4 * uniform(random) - 2, 2 * uniform(random) - 1);
      ClosestPoint best = closest_point_on_face(mesh, FaceId(0), query);
      for (int f = 1; f < mesh.face_count(); ++f) {
        const ClosestPoint found = closest_point_on_face(mesh, FaceId(f), query);
        if (found.distance < best.distance) best = found;
      }
      const ClosestPoint found = tree.query(query);
      CHECK(found.distance == best.distance);
      CHECK(found.point.face == best.point.face);
      CHECK(found.distance == Approx((position(mesh, found.point) - query).norm()).margin(1e-9));
    }
    const SurfacePoint on = random_point(mesh, random);
    CHECK(tree.query(position(mesh, on)).distance < 1e-12);
  }
}

TEST_CASE("the closest point of a face without area lies on its edges") {
  const Mesh mesh({{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}, {{VertexId(0), VertexId(1), VertexId(2)}});
  const ClosestPoint found = closest_point_on_face(mesh, FaceId(0), {2, 1, 0});
  CHECK(found.distance == Approx(1));
  CHECK((position(mesh, found.point) - Vec3(2, 0, 0)).norm() < 1e-12);
}
