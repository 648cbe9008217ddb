#include "separate_coincident_corners.hpp"
#include "support/catch.hpp"

namespace gvd::test_separate_coincident_corners {

/// One parent, cut in two triangles at vertices 2 and 3; vertices 0 and 1 are the input's.
CutTriangles make_cut(std::vector<Vec3> positions) {
  CutTriangles cut;
  cut.positions = std::move(positions);
  cut.faces = {{VertexId(0), VertexId(1), VertexId(2)}, {VertexId(0), VertexId(2), VertexId(3)}};
  cut.parent = IdVector<FaceId, FaceId>(2, FaceId(0));
  return cut;
}

TEST_CASE("coincident corners: different corners do not move") {
  CutTriangles cut = make_cut({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  const std::vector<Vec3> before = cut.positions;
  CHECK(separate_coincident_corners(cut, 2, 1e-15) == 0);
  CHECK(cut.positions == before);
}

TEST_CASE("coincident corners: an added vertex moves along the longest edge, away from one of the input") {
  CutTriangles cut = make_cut({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  CHECK(separate_coincident_corners(cut, 2, 1e-3) == 1);
  CHECK(cut.positions[1] == Vec3(1, 0, 0));
  CHECK((cut.positions[2] - Vec3(1, 0, 0)).norm() == Approx(1e-3));
  CHECK(cut.positions[3] == Vec3(0, 1, 0));
}

TEST_CASE("coincident corners: vertices of the input do not move") {
  CutTriangles cut = make_cut({{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  const std::vector<Vec3> before = cut.positions;
  CHECK(separate_coincident_corners(cut, 2, 1e-3) == 0);
  CHECK(cut.positions == before);
}

TEST_CASE("coincident corners: a parent whose corners all coincide is left as it is, in no round") {
  CutTriangles cut = make_cut(std::vector<Vec3>(4, Vec3(1, 2, 3)));
  CHECK(separate_coincident_corners(cut, 2, 1e-3) == 0);
  CHECK(cut.positions == std::vector<Vec3>(4, Vec3(1, 2, 3)));
}

}  // namespace gvd::test_separate_coincident_corners
