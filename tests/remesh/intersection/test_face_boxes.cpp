// The faces that a box finds.
#include <algorithm>

#include "intersection/face_boxes.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/random.hpp"

namespace gvd::test_face_boxes {

TEST_CASE("a box finds exactly the faces whose boxes overlap it") {
  const Mesh mesh = test::make_torus(20, 10);
  const FaceBoxes boxes(mesh);
  test::Random random(1);
  for (int i = 0; i < 50; ++i) {
    const Vec3 low(random.real(-1.5, 1.5), random.real(-1.5, 1.5), random.real(-0.5, 0.5));
    const Box3 box{low, low + Vec3::Constant(random.real(0, 0.5))};
    std::vector<FaceId> found, wanted;
    boxes.visit(box, [&](FaceId f) { found.push_back(f); });
    std::sort(found.begin(), found.end());
    for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
      if (overlap(face_box(mesh, FaceId(f)), box)) wanted.push_back(FaceId(f));
    }
    CHECK(found == wanted);
  }
}

TEST_CASE("closed boxes that touch overlap, and an empty mesh has none") {
  const Box3 unit{{0, 0, 0}, {1, 1, 1}};
  CHECK(overlap(unit, {{1, 1, 1}, {2, 2, 2}}));
  CHECK_FALSE(overlap(unit, {{1, 1, 1.5}, {2, 2, 2}}));
  FaceBoxes(Mesh()).visit(unit, [](FaceId) { FAIL(); });
}

}  // namespace gvd::test_face_boxes
