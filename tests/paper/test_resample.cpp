#include <cstdint>

#include "gvd/error.hpp"
#include "gvd/quality.hpp"
#include "resample.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

using namespace gvd;
using namespace gvd::paper;

namespace {

bool has_same_faces(const Mesh& a, const Mesh& b) {
  if (a.face_count() != b.face_count()) return false;
  for (std::int32_t f = 0; f < a.face_count(); ++f) {
    if (a.vertices(FaceId(f)) != b.vertices(FaceId(f))) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("a resampled torus has about as many faces as asked for, good ones, and the same topology") {
  const Mesh torus = test::make_torus(40, 20);
  for (const int faces : {400, 1600, 6000}) {
    const Mesh resampled = resample(torus, faces);
    CAPTURE(faces, resampled.face_count());
    CHECK(resampled.face_count() > 0.8 * faces);
    CHECK(resampled.face_count() < 1.25 * faces);
    CHECK(compute_triangle_quality(resampled).q_average > 0.8);
    CHECK(compute_mesh_summary(resampled).euler_characteristic == 0);
    CHECK(compute_mesh_summary(resampled).area == Approx(compute_mesh_summary(torus).area).epsilon(0.1));
  }
}

TEST_CASE("a mesh with a boundary is not resampled") { CHECK_THROWS_AS(resample(test::make_grid(3, 3), 100), Error); }

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

TEST_CASE("the icosphere is closed, of radius 1 and faces outwards") {
  for (const int subdivisions : {0, 3}) {
    const Mesh sphere = make_icosphere(subdivisions);
    CHECK(sphere.face_count() == 20 << 2 * subdivisions);
    CHECK(compute_mesh_summary(sphere).euler_characteristic == 2);
    for (const Vec3& p : sphere.positions()) CHECK(p.norm() == Approx(1));
    const auto& [a, b, c] = sphere.vertices(FaceId(0));
    const Vec3 &pa = sphere.position(a), &pb = sphere.position(b), &pc = sphere.position(c);
    CHECK((pb - pa).cross(pc - pa).dot(pa) > 0);
  }
}
