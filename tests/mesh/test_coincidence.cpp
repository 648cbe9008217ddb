#include "mesh/coincidence.hpp"
#include "support/catch.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_coincidence {

TEST_CASE("coincidence is a part of the bounding box near the origin, and follows the scale") {
  const Mesh mesh = test::make_tetrahedron();
  CHECK(coincidence(mesh) == kCoincidence * mesh.bbox_diagonal());
  CHECK(coincidence(test::scaled(mesh, 1e6)) == Approx(1e6 * coincidence(mesh)));
}

TEST_CASE("far from the origin coincidence is the rounding of the coordinates") {
  const auto shifted = [](double x) { return test::make_mesh({{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}}, {{0, 1, 2}}); };
  CHECK(coincidence(shifted(1e6)) == kCoordinateRounding * (1e6 + 1));
  CHECK(coincidence(shifted(-1e6)) == kCoordinateRounding * 1e6);
  CHECK(coincidence(shifted(1)) == kCoincidence * shifted(1).bbox_diagonal());
}

}  // namespace gvd::test_coincidence
