#include "icosphere.hpp"
#include "support/catch.hpp"

namespace gvd::test_icosphere {

using namespace paper;

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

}  // namespace gvd::test_icosphere
