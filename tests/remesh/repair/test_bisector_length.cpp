#include "repair/bisector_length.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_bisector_length {

/// A bisector along the bottom of a grid, through the points with these x.
Bisector make_bisector(const std::vector<double>& xs) {
  Bisector b;
  for (const double x : xs) {
    const int square = std::min(static_cast<int>(x), 3);
    b.points.push_back(edge_point(Mesh::halfedge(FaceId(2 * square), 0), x - square));
  }
  return b;
}

TEST_CASE("bisector length: of a single point it is 0, and the point is the middle") {
  const Mesh mesh = test::make_grid(4, 1);
  const Bisector b = make_bisector({1.5});
  CHECK(compute_length(mesh, b) == 0);
  CHECK(find_midpoint(mesh, b) == b.points[0]);
}

TEST_CASE("bisector length: coincident points have length 0") {
  const Mesh mesh = test::make_grid(4, 1);
  const Bisector b = make_bisector({1.5, 1.5, 1.5});
  CHECK(compute_length(mesh, b) == 0);
  CHECK(position(mesh, find_midpoint(mesh, b)) == Vec3(1.5, 0, 0));
}

TEST_CASE("bisector length: the midpoint is the point nearest to half of the length") {
  const Mesh mesh = test::make_grid(4, 1);
  const auto middle = [&](const std::vector<double>& xs) {
    return position(mesh, find_midpoint(mesh, make_bisector(xs))).x();
  };
  CHECK(compute_length(mesh, make_bisector({0.5, 1, 3.5})) == Approx(3));
  CHECK(middle({0, 1, 2, 3, 4}) == 2);
  CHECK(middle({0, 0.25, 0.5, 4}) == Approx(0.5));
  CHECK(middle({0, 3.5, 4}) == Approx(3.5));
  CHECK(middle({0, 4}) == 4);  // of two equally near, the later one
}

}  // namespace gvd::test_bisector_length
