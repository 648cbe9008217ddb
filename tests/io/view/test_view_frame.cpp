#include "io/view/view_frame.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_view_frame {

using namespace test;

ViewScene scene_of(const Mesh& mesh) {
  ViewScene scene;
  scene.mesh = &mesh;
  return scene;
}

TEST_CASE("the frame is the centre and half the diagonal of the box around all scenes") {
  const Mesh grid = make_grid(4, 3);
  const io::ViewFrame frame = io::compute_view_frame({scene_of(grid)});
  CHECK((frame.origin - Vec3(2, 1.5, 0)).norm() < 1e-15);
  CHECK(frame.scale == Approx(2.5));
  const Mesh far({{10, 0, 0}, {11, 0, 0}, {10, 3, 0}}, {{VertexId(0), VertexId(1), VertexId(2)}});
  const io::ViewFrame both = io::compute_view_frame({scene_of(grid), scene_of(far)});
  CHECK((both.origin - Vec3(5.5, 1.5, 0)).norm() < 1e-15);
  ViewScene over = scene_of(grid);
  over.overlay = ViewOverlay{"", &far};
  CHECK(io::compute_view_frame({over}).origin == both.origin);
}

TEST_CASE("the frame of very large and very small coordinates is finite") {
  for (const double size : {1e150, 1e-150}) {
    const Mesh mesh({{-size, 0, 0}, {size, 0, 0}, {0, size, 0}}, {{VertexId(0), VertexId(1), VertexId(2)}});
    const io::ViewFrame frame = io::compute_view_frame({scene_of(mesh)});
    CHECK(frame.origin.allFinite());
    CHECK(frame.scale > 0);
    CHECK(std::isfinite(frame.scale));
  }
}

}  // namespace gvd::test_view_frame
