#include <numbers>

#include "diffusion/diffusion.hpp"
#include "judging/turning.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_turning {

using namespace paper;

constexpr double kPi = std::numbers::pi;

Diagram with_bisector(std::vector<SurfacePoint> points, bool closed = false) {
  Diagram diagram;
  Bisector bisector;
  bisector.points = std::move(points);
  bisector.closed = closed;
  diagram.bisectors.push_back(bisector);
  return diagram;
}

SurfacePoint in_face(double v, double w) { return make_surface_point(FaceId(0), {1 - v - w, v, w}); }

TEST_CASE("a bisector turns by the angles at its inner points, to either side") {
  const Mesh mesh = test::make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  CHECK(sum_turning_angles(mesh, with_bisector({in_face(0.1, 0.1), in_face(0.4, 0.1)})) == 0);
  CHECK(sum_turning_angles(mesh, with_bisector({in_face(0.1, 0.1), in_face(0.2, 0.1), in_face(0.2, 0.2),
                                                in_face(0.3, 0.2)})) == Approx(kPi));
  const Diagram closed =
      with_bisector({in_face(0.1, 0.1), in_face(0.2, 0.1), in_face(0.2, 0.2), in_face(0.1, 0.2)}, true);
  CHECK(sum_turning_angles(mesh, closed) == Approx(2 * kPi));
}

TEST_CASE("points in one place do not turn, and one point or none neither") {
  const Mesh mesh = test::make_triangle();
  const SurfacePoint a = in_face(0.1, 0.1), b = in_face(0.2, 0.2), c = in_face(0.3, 0.3);
  CHECK(sum_turning_angles(mesh, with_bisector({a, b, b, c})) == Approx(0).margin(1e-6));
  CHECK(sum_turning_angles(mesh, with_bisector({a})) == 0);
  CHECK(sum_turning_angles(mesh, with_bisector({})) == 0);
}

TEST_CASE("a straight line over a folded edge turns by nothing") {
  // Two faces at a right angle along the y axis; the line runs in both at 45 degrees to it.
  const Mesh mesh = test::make_mesh({{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 1, 1}}, {{0, 1, 2}, {1, 0, 3}});
  const SurfacePoint before = make_surface_point(FaceId(0), {0.5, 0.25, 0.25});
  const SurfacePoint middle = edge_point(Mesh::halfedge(FaceId(0), 0), 0.5);
  const SurfacePoint after = make_surface_point(FaceId(1), {0.5, 0.25, 0.25});
  CHECK(sum_turning_angles(mesh, with_bisector({before, middle, after})) == Approx(0).margin(1e-12));
}

TEST_CASE("diffusion diagrams zig-zag more than exact ones") {
  const Mesh mesh = test::make_bumpy_sphere(3, 2);
  std::vector<SurfacePoint> generators;
  for (int i = 0; i < 10; ++i) generators.push_back(vertex_point(mesh, VertexId(1 + 60 * i)));
  const Diagram exact = compute_diagram(mesh, generators);
  const Diagram diffusion = compute_diffusion(mesh, generators).diagram;
  CHECK(sum_turning_angles(mesh, diffusion) / diffusion.length > 2 * sum_turning_angles(mesh, exact) / exact.length);
}

}  // namespace gvd::test_turning
