#include <cstdint>

#include "gvd/quality.hpp"
#include "jitter.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_jitter {

using namespace paper;

bool has_same_faces(const Mesh& a, const Mesh& b) {
  if (a.face_count() != b.face_count()) return false;
  for (std::int32_t f = 0; f < a.face_count(); ++f) {
    if (a.vertices(FaceId(f)) != b.vertices(FaceId(f))) return false;
  }
  return true;
}

TEST_CASE("a jitter makes small angles, and leaves the faces and the surface") {
  const Mesh sphere = test::make_sphere(3);
  const Mesh jittered = jitter(sphere, 40, 1);
  CHECK(has_same_faces(sphere, jittered));
  CHECK(compute_triangle_quality(jittered).percent_below_30 >= 40);
  CHECK(compute_triangle_quality(jittered).q_min >= 0.1);
  CHECK(compute_mesh_summary(jittered).area == Approx(compute_mesh_summary(sphere).area).epsilon(0.05));
}

TEST_CASE("a jitter repeats itself for a seed, and differs between seeds") {
  const Mesh sphere = test::make_sphere(2);
  CHECK(jitter(sphere, 30, 1).positions() == jitter(sphere, 30, 1).positions());
  CHECK(jitter(sphere, 30, 1).positions() != jitter(sphere, 30, 2).positions());
}

TEST_CASE("a mesh that is bad enough is not jittered") {
  const Mesh sphere = test::make_sphere(2);
  CHECK(jitter(sphere, 0, 1).positions() == sphere.positions());
}

}  // namespace gvd::test_jitter
