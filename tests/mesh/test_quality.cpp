#include <cmath>

#include "gvd/quality.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_quality {

TEST_CASE("Q and the least angle of known triangles") {
  const Vec3 o(0, 0, 0), x(1, 0, 0), y(0, 1, 0), apex(0.5, std::sqrt(3.0) / 2, 0);
  CHECK(compute_q(o, x, apex) == Approx(1).epsilon(1e-14));
  CHECK(compute_min_angle(o, x, apex) == Approx(60).epsilon(1e-14));
  // Right isosceles: area 1/2, half perimeter 1 + sqrt(2)/2, longest edge sqrt(2).
  CHECK(compute_q(o, x, y) == Approx(6 / std::sqrt(3.0) * 0.5 / ((1 + std::sqrt(0.5)) * std::sqrt(2.0))));
  CHECK(compute_min_angle(o, x, y) == Approx(45));
}

TEST_CASE("a triangle without area has Q 0 and angle 0, never NaN") {
  const Vec3 o(0, 0, 0), x(1, 0, 0), far(3, 0, 0);
  CHECK(compute_q(o, x, far) == 0);
  CHECK(compute_min_angle(o, x, far) == 0);
  CHECK(compute_q(o, o, o) == 0);
  CHECK(compute_min_angle(o, o, x) == 0);
}

TEST_CASE("Q does not depend on size, place or the order of the corners") {
  const Vec3 a(0.1, 0.7, -0.2), b(1.3, 0.2, 0.4), c(0.4, -0.9, 0.8), shift(10, -20, 30);
  const double q = compute_q(a, b, c), angle = compute_min_angle(a, b, c);
  CHECK(compute_q(c, a, b) == Approx(q).epsilon(1e-13));
  CHECK(compute_q(b, a, c) == Approx(q).epsilon(1e-13));
  CHECK(compute_q(1e-6 * a, 1e-6 * b, 1e-6 * c) == Approx(q).epsilon(1e-13));
  CHECK(compute_min_angle(1e6 * a + shift, 1e6 * b + shift, 1e6 * c + shift) == Approx(angle).epsilon(1e-9));
}

TEST_CASE("the figures of a grid are those of its one triangle") {
  const TriangleQuality quality = compute_triangle_quality(test::make_grid(5, 4));
  CHECK(quality.q_min == Approx(0.7174).margin(5e-5));
  CHECK(quality.q_average == Approx(quality.q_min));
  CHECK(quality.angle_min == Approx(45));
  CHECK(quality.angle_min_average == Approx(45));
  CHECK(quality.percent_below_30 == 0);
}

TEST_CASE("an angle of 30 degrees is not below 30 degrees") {
  const double height = std::tan(M_PI / 6);
  const Mesh exact({{0, 0, 0}, {1, 0, 0}, {1, height, 0}}, {{VertexId(0), VertexId(1), VertexId(2)}});
  const Mesh below({{0, 0, 0}, {1, 0, 0}, {1, height - 1e-6, 0}}, {{VertexId(0), VertexId(1), VertexId(2)}});
  CHECK(compute_triangle_quality(exact).percent_below_30 == 0);
  CHECK(compute_triangle_quality(below).percent_below_30 == 100);
}

TEST_CASE("the figures of every family are in their ranges, and thin faces lower them") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    const TriangleQuality quality = compute_triangle_quality(mesh);
    CHECK(quality.q_min >= 0);
    CHECK(quality.q_min <= quality.q_average + 1e-12);
    CHECK(quality.q_average <= 1 + 1e-12);
    CHECK(quality.angle_min <= quality.angle_min_average + 1e-10);
    CHECK(quality.angle_min_average <= 60);
    CHECK((quality.percent_below_30 > 0 || quality.angle_min > 30 - 1e-6));
  }
  CHECK(compute_triangle_quality(test::make_thin_faced_sphere(3, 7)).percent_below_30 > 30);
  CHECK(compute_triangle_quality(Mesh()).q_average == 0);
}

TEST_CASE("valences of an icosahedron, its subdivision and a grid") {
  const Valences icosahedron = compute_valences(test::make_sphere(0)), sphere = compute_valences(test::make_sphere(1));
  CHECK((icosahedron.least == 5 && icosahedron.largest == 5 && icosahedron.percent_regular == 0));
  CHECK((sphere.least == 5 && sphere.largest == 6));
  CHECK(sphere.percent_regular == Approx(100.0 * 30 / 42));
  // 3 x 3 vertices: corners have two or three edges, the middles of the sides four, the inner one six.
  const Valences grid = compute_valences(test::make_grid(2, 2));
  CHECK((grid.least == 2 && grid.largest == 6));
  CHECK(grid.percent_regular == Approx(100.0 * 5 / 9));
  CHECK(compute_valences(Mesh()).largest == 0);
}

}  // namespace gvd::test_quality
