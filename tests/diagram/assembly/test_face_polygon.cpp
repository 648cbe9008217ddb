#include <cmath>

#include "diagram/assembly/face_polygon.hpp"
#include "support/catch.hpp"
#include "support/face_polygon.hpp"

namespace gvd::test_face_polygon {

/// The point of the face at these affine coordinates.
Bary at_affine(double x, double y) { return {1 - x - y, x, y}; }

const std::vector<Bary> kSquare{at_affine(0.1, 0.1), at_affine(0.4, 0.1), at_affine(0.4, 0.4), at_affine(0.1, 0.4)};

TEST_CASE("points on one line are convex, in their order and back") {
  CHECK(is_convex({at_affine(0, 0), at_affine(0.5, 0), at_affine(1, 0)}, 0));
  CHECK(is_convex({at_affine(0.2, 0.2), at_affine(0.2, 0.2), at_affine(0.2, 0.2)}, 0));
}

TEST_CASE("a square is convex counter-clockwise, and not clockwise or with a dent") {
  CHECK(is_convex(kSquare, 0));
  CHECK_FALSE(is_convex({kSquare.rbegin(), kSquare.rend()}, 0));
  std::vector<Bary> dented = kSquare;
  dented[2] = at_affine(0.2, 0.2);
  CHECK_FALSE(is_convex(dented, 0));
  CHECK_FALSE(is_convex(dented, 1e-3));
}

TEST_CASE("a corner beyond its neighbours' line counts as convex up to the tolerance") {
  const auto with_dent = [](double depth) {
    std::vector<Bary> polygon = kSquare;
    polygon.insert(polygon.begin() + 1, at_affine(0.25, 0.1 + depth));
    return polygon;
  };
  CHECK(is_convex(with_dent(0), 0));
  CHECK_FALSE(is_convex(with_dent(1e-12), 0));
  CHECK(is_convex(with_dent(1e-12), 4e-12));
  CHECK_FALSE(is_convex(with_dent(1e-11), 4e-12));
}

TEST_CASE("inside: the corners and sides belong to a polygon, what lies outside of the face does not") {
  const auto boundary = test::boundary_of({{0.5, 1}, {1.5, 2}, {2.5, 0}});
  const FacePolygon polygon = test::polygon_of(boundary);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(is_inside(polygon, polygon[i].bary, 0));
    CHECK(is_inside(polygon, midpoint(polygon, i), 1e-15));
  }
  CHECK(is_inside(polygon, centre(polygon), 0));
  CHECK_FALSE(is_inside(polygon, at_affine(0.05, 0.05), 0));
  CHECK_FALSE(is_inside(polygon, {0.6, 0.5, -0.1}, 1));  // however large the tolerance
}

TEST_CASE("crossings of one edge span a polygon without area, and only points of that edge are inside") {
  const FacePolygon polygon = test::polygon_of(test::boundary_of({{0.2, 1}, {0.5, 2}, {0.8, 0}}));
  CHECK(is_inside(polygon, at_affine(0.5, 0), 0));
  CHECK_FALSE(is_inside(polygon, at_affine(0.5, 0.1), 0));
}

TEST_CASE("midpoints, the centre and distances are those of barycentric coordinates") {
  const FacePolygon polygon = test::polygon_of(test::boundary_of({{0.0, 1}, {1.0, 2}, {2.0, 0}}));
  CHECK(midpoint(polygon, 2) == Bary{0.5, 0, 0.5});
  for (const double coordinate : centre(polygon)) CHECK(coordinate == Approx(1.0 / 3));
  CHECK(bary_distance({1, 0, 0}, {0, 1, 0}) == 1);
  CHECK(bary_distance({0, 1, 0}, {0, 0, 1}) == Approx(std::sqrt(2)));
}

}  // namespace gvd::test_face_polygon
