// The faces of a working mesh in the faces of the input that it splits.
#include <algorithm>

#include "mesh/working_mesh.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

namespace gvd::test_split_faces {

/// By the least barycentric coordinate, in the plane of the parent.
PlacedInTriangle place(const std::array<Bary, 3>& corners, const Bary& point) {
  const auto area = [](const Bary& a, const Bary& b, const Bary& c) {
    return twice_signed_area(affine_point(a), affine_point(b), affine_point(c));
  };
  const double whole = area(corners[0], corners[1], corners[2]);
  const Bary local{area(point, corners[1], corners[2]) / whole, area(corners[0], point, corners[2]) / whole,
                   area(corners[0], corners[1], point) / whole};
  return {local, -std::min({local[0], local[1], local[2]})};
}

TEST_CASE("split faces: without parts no point is found") {
  const SurfacePoint none = locate_in_parts({}, [](const auto&) { return PlacedInTriangle{}; });
  CHECK_FALSE(none.face.valid());
}

TEST_CASE("split faces: the parts cover each split face once") {
  for (const auto& [name, mesh] : test::small_family()) {
    CAPTURE(name);
    const WorkingMesh working(mesh, test::random_generators(mesh, 8, 3));
    const SplitFaces split(working);
    std::size_t parts = 0;
    for (int f = 0; f < mesh.face_count(); ++f) {
      double share = 0;
      for (const SplitFaces::Part& part : split.parts_of(FaceId(f))) {
        REQUIRE(part.parent == FaceId(f));
        REQUIRE(working.parent(part.face) == FaceId(f));
        share += twice_signed_area(affine_point(part.corners[0]), affine_point(part.corners[1]),
                                   affine_point(part.corners[2]));
        ++parts;
      }
      CHECK((split.parts_of(FaceId(f)).empty() || share == Approx(1)));
    }
    std::size_t expected = 0;
    for (int f = 0; f < working.mesh().face_count(); ++f) expected += working.is_split(FaceId(f));
    CHECK(parts == expected);
  }
}

TEST_CASE("split faces: a point of a split face is found in the part that contains it") {
  const Mesh mesh = test::make_sphere(1);
  const WorkingMesh working(mesh, {{FaceId(3), {0.2, 0.3, 0.5}}, {FaceId(3), {0.6, 0.3, 0.1}}});
  const SplitFaces split(working);
  REQUIRE(split.parts_of(FaceId(3)).size() == 5);
  CHECK(split.parts_of(FaceId(4)).empty());
  for (const Bary& point : {Bary{0.25, 0.35, 0.4}, Bary{0.9, 0.05, 0.05}, Bary{0.1, 0.1, 0.8}, Bary{0.3, 0.65, 0.05}}) {
    const SurfacePoint inside = locate_in_parts(
        split.parts_of(FaceId(3)), [&](const std::array<Bary, 3>& corners) { return place(corners, point); });
    CHECK(*std::min_element(inside.bary.begin(), inside.bary.end()) >= 0);
    CHECK((position(working.mesh(), inside) - position(mesh, {FaceId(3), point})).norm() < 1e-15);
  }
}

}  // namespace gvd::test_split_faces
