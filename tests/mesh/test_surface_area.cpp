#include "gvd/surface_area.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_surface_area {

TEST_CASE("the area of a mesh is that of its summary, and 0 without faces") {
  CHECK(compute_area(Mesh()) == 0);
  CHECK(compute_area(test::make_grid(3, 3)) == Approx(compute_mesh_summary(test::make_grid(3, 3)).area));
  for (const auto& [name, mesh] : test::small_family()) {
    CAPTURE(name);
    double area = 0;
    for (int f = 0; f < mesh.face_count(); ++f) {
      const auto [a, b, c] = mesh.vertices(FaceId(f));
      area += (mesh.position(b) - mesh.position(a)).cross(mesh.position(c) - mesh.position(a)).norm() / 2;
    }
    CHECK(compute_area(mesh) == Approx(area));
  }
}

}  // namespace gvd::test_surface_area
