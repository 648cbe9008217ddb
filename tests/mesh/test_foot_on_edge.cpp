#include "mesh/foot_on_edge.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_foot_on_edge {

TEST_CASE("foot on edge: a point of the line has its own parameter, and moves across change nothing") {
  const Mesh mesh = test::make_grid(2, 2);
  for (std::int32_t i = 0; i < mesh.halfedge_count(); ++i) {
    const HalfedgeId h(i);
    const Vec3 from = mesh.position(mesh.from(h)), along = mesh.position(mesh.to(h)) - from;
    const Vec3 across = along.unitOrthogonal();
    for (const double t : {-0.5, 0.0, 0.25, 1.0, 2.0}) {
      CHECK(foot_on_edge(mesh, h, from + t * along) == Approx(t).margin(1e-12));
      CHECK(foot_on_edge(mesh, h, from + t * along + 3 * across) == Approx(t).margin(1e-12));
    }
  }
}

}  // namespace gvd::test_foot_on_edge
