#include <algorithm>

#include "decimate.hpp"
#include "gvd/quality.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_decimate {

using namespace paper;

TEST_CASE("a decimated mesh has the faces asked for, the topology and the surface, and worse triangles") {
  const Mesh torus = test::make_torus(60, 40);
  const Mesh decimated = decimate(torus, 1200);
  CHECK(decimated.face_count() == 1200);
  CHECK(compute_mesh_summary(decimated).euler_characteristic == 0);
  CHECK(compute_mesh_summary(decimated).area == Approx(compute_mesh_summary(torus).area).epsilon(0.02));
  CHECK(compute_triangle_quality(decimated).q_average < compute_triangle_quality(torus).q_average);
}

TEST_CASE("vertices of a decimated mesh are vertices of the mesh") {
  const Mesh sphere = test::make_sphere(3);
  const Mesh decimated = decimate(sphere, 300);
  for (const Vec3& p : decimated.positions()) {
    CHECK(std::find(sphere.positions().begin(), sphere.positions().end(), p) != sphere.positions().end());
  }
}

TEST_CASE("a mesh with fewer faces than asked for stays as it is") {
  CHECK(decimate(test::make_sphere(1), 1000).face_count() == test::make_sphere(1).face_count());
}

}  // namespace gvd::test_decimate
