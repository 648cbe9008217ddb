#include <cmath>

#include "flat_square.hpp"
#include "gvd/lloyd.hpp"
#include "gvd/mesh.hpp"
#include "support/catch.hpp"

namespace gvd::test_flat_square {

using namespace bench;

TEST_CASE("a flat square has the area n x n and one boundary") {
  const Mesh mesh = make_flat_square(5);
  CHECK(mesh.face_count() == 50);
  CHECK(mesh.vertex_count() == 36);
  CHECK(compute_area(mesh) == Approx(25));
}

TEST_CASE("the interior of a square of square cells has the energy of squares, 1 / 6") {
  const int n = 8;
  const Mesh mesh = make_flat_square(n);
  std::vector<SurfacePoint> centres;
  // The middle of each unit square is the middle of the diagonal, which both faces share.
  for (int square = 0; square < n * n; ++square) centres.push_back({FaceId(2 * square), {0.5, 0, 0.5}});
  const Diagram diagram = compute_diagram(mesh, centres);
  const InteriorEnergy all = interior_energy(mesh, n, diagram, 0);
  CHECK(all.cells == n * n);
  CHECK(all.energy == Approx(1.0 / 6).epsilon(1e-9));
  const InteriorEnergy inner = interior_energy(mesh, n, diagram, 2);
  CHECK(inner.cells == (n - 4) * (n - 4));
  CHECK(inner.energy == Approx(1.0 / 6).epsilon(1e-9));
  CHECK(interior_energy(mesh, n, diagram, n).cells == 0);
}

}  // namespace gvd::test_flat_square
