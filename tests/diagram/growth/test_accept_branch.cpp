#include "diagram/growth/accept_branch.hpp"
#include "geodesic/face_layout.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/stages.hpp"

namespace gvd::test_accept_branch {

/// Two ends in the face of a flat grid that holds the circumcentre of three generators, with the generators' true
/// positions as images.
struct TwoEnds {
  static constexpr int kSquares = 16;
  static int at(int i, int j) { return j * (kSquares + 1) + i; }

  Mesh mesh = test::make_grid(kSquares, kSquares);
  test::Stages stages;
  GrowingEnd first{}, second{};
  Vec2 centre;

  explicit TwoEnds(std::vector<int> generators = {at(3, 3), at(13, 3), at(8, 13)})
      : stages(mesh, test::at_vertices(mesh, generators), Front::circle) {
    // (8, 6.75) is at the distance 6.25 from (3, 3), (13, 3) and (8, 13).
    const FaceId f(2 * (6 * kSquares + 8));
    first.face = second.face = f;
    first.left = GeneratorId(0);
    first.right = second.left = GeneratorId(1);
    second.right = GeneratorId(2);
    first.left_image = in_plane(3, 3);
    first.right_image = second.left_image = in_plane(13, 3);
    second.right_image = in_plane(8, 13);
    centre = in_plane(8, 6.75);
  }

  /// A point of the grid in the plane of the face.
  Vec2 in_plane(double x, double y) const {
    const FaceLayout layout(mesh, first.face.valid() ? first.face : FaceId(2 * (6 * kSquares + 8)));
    const auto& [a, b, c] = mesh.vertices(FaceId(2 * (6 * kSquares + 8)));
    const Vec3 &pa = mesh.position(a), u = mesh.position(b) - pa, v = mesh.position(c) - pa, w = Vec3(x, y, 0) - pa;
    const double area = u.cross(v).z(), s = w.cross(v).z() / area, t = u.cross(w).z() / area;
    return layout.at({1 - s - t, s, t});
  }
};

TEST_CASE("the distance of a branch point is the mean of its three generators'") {
  const TwoEnds ends;
  CHECK(branch_distance(ends.first, ends.second, ends.centre) == Approx(6.25));
  // A point off the centre: the three count the same.
  const double mean = (std::hypot(5, 5) + std::hypot(5, 5) + 5) / 3;
  CHECK(branch_distance(ends.first, ends.second, ends.in_plane(8, 8)) == Approx(mean));
}

TEST_CASE("a branch point has to be equally far from its three generators") {
  const TwoEnds ends;
  CHECK(accept_branch(ends.stages.input(), ends.first, ends.second, ends.centre));
  CHECK(accept_branch(ends.stages.input(), ends.first, ends.second, ends.in_plane(8, 6.9)));
  CHECK_FALSE(accept_branch(ends.stages.input(), ends.first, ends.second, ends.in_plane(8, 7.5)));
}

TEST_CASE("a branch point has to be farther from all other generators") {
  const int near = TwoEnds::at(8, 5);
  const TwoEnds ends({TwoEnds::at(3, 3), TwoEnds::at(13, 3), TwoEnds::at(8, 13), near});
  CHECK_FALSE(accept_branch(ends.stages.input(), ends.first, ends.second, ends.centre));
}

}  // namespace gvd::test_accept_branch
