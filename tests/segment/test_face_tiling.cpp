// The polygons of one face: merged corners, split segments, and pieces that do not tile it.
#include "base/barycentric.hpp"
#include "face_tiling.hpp"
#include "support/catch.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_face_tiling {

constexpr double kTolerance = 1e-14;

/// A right triangle with legs 4; corner i is vertex i. `on_side`: points of its border on the side from 0 to 1, with
/// vertices 3, 4, ...
class Face {
 public:
  explicit Face(const std::vector<double>& on_side = {}) {
    std::vector<FaceTiling::Corner> border{corner({1, 0, 0}, 0)};
    int vertex = 3;
    for (const double t : on_side) border.push_back(corner({1 - t, t, 0}, vertex++));
    border.push_back(corner({0, 1, 0}, 1));
    border.push_back(corner({0, 0, 1}, 2));
    tiling_.emplace(std::move(border), kTolerance);
  }

  FaceTiling& tiling() { return *tiling_; }
  static FaceTiling::Corner corner(const Bary& b, int vertex = -1) {
    return {b, Vec3(4 * b[1], 4 * b[2], 0), VertexId(vertex)};
  }
  std::size_t inner(const Bary& b) { return tiling_->find_or_add(corner(b)); }
  std::size_t vertex(int v) { return tiling_->find_or_add(corner({1, 0, 0}, v)); }

 private:
  std::optional<FaceTiling> tiling_;
};

TEST_CASE("face tiling: a vertex of the border is found by its id, wherever it claims to be") {
  Face face({0.5});
  CHECK(face.vertex(0) == 0);
  CHECK(face.vertex(3) == 1);
  CHECK(face.vertex(2) == 3);
  CHECK(face.tiling().corners().size() == 4);
}

TEST_CASE("face tiling: inner corners merge within kCutWeld, in coordinates or in position") {
  Face face;
  const std::size_t first = face.inner({0.5, 0.25, 0.25});
  CHECK(first == 3);
  CHECK(face.inner({0.5, 0.25, 0.25}) == first);
  CHECK(face.inner({0.5 - 0.9 * kCutWeld, 0.25 + 0.9 * kCutWeld, 0.25}) == first);
  const std::size_t second = face.inner({0.5 - 3 * kCutWeld, 0.25 + 3 * kCutWeld, 0.25});
  CHECK(second == 4);
  // The same position with other coordinates, as in a degenerate face.
  FaceTiling::Corner same_position = Face::corner({0.2, 0.4, 0.4});
  same_position.position = face.tiling().corners()[first].position;
  CHECK(face.tiling().find_or_add(same_position) == first);
  CHECK(face.tiling().corners().size() == 5);
}

TEST_CASE("face tiling: two pieces with a common segment tile the face") {
  Face face({0.5});
  FaceTiling& tiling = face.tiling();
  tiling.add({GeneratorId(0), {face.vertex(0), face.vertex(3), face.vertex(2)}});
  tiling.add({GeneratorId(1), {face.vertex(3), face.vertex(1), face.vertex(2)}});
  REQUIRE(tiling.fit());
  CHECK(tiling.polygons().size() == 2);
}

TEST_CASE("face tiling: a corner on the segment of another polygon splits it") {
  Face face({0.5});
  FaceTiling& tiling = face.tiling();
  // The left piece does not know the point in the middle of the segment from vertex 3 to vertex 2.
  const std::size_t middle = face.inner({0.25, 0.25, 0.5}), right = face.inner({0.125, 0.625, 0.25});
  tiling.add({GeneratorId(0), {face.vertex(0), face.vertex(3), face.vertex(2)}});
  tiling.add({GeneratorId(1), {face.vertex(3), right, middle}});
  tiling.add({GeneratorId(2), {face.vertex(3), face.vertex(1), face.vertex(2), middle, right}});
  REQUIRE(tiling.fit());
  CHECK(tiling.polygons()[0].corners == std::vector<std::size_t>{0, 1, middle, face.vertex(2)});
}

TEST_CASE("face tiling: a missing piece and an overlap are found") {
  Face missing({0.5});
  missing.tiling().add({GeneratorId(0), {missing.vertex(0), missing.vertex(3), missing.vertex(2)}});
  CHECK_FALSE(missing.tiling().fit());
  Face twice;
  for (int i = 0; i < 2; ++i) twice.tiling().add({GeneratorId(i), {0, 1, 2}});
  CHECK_FALSE(twice.tiling().fit());
  Face clockwise;
  clockwise.tiling().add({GeneratorId(0), {0, 2, 1}});
  CHECK_FALSE(clockwise.tiling().fit());
}

TEST_CASE("face tiling: a face left whole is one polygon with all points of its border") {
  Face face({0.25, 0.75});
  face.inner({0.5, 0.25, 0.25});
  face.tiling().add({GeneratorId(0), {0, 1, 2}});
  face.tiling().leave_whole(GeneratorId(6));
  REQUIRE(face.tiling().polygons().size() == 1);
  CHECK(face.tiling().polygons()[0].generator == GeneratorId(6));
  CHECK(face.tiling().polygons()[0].corners == std::vector<std::size_t>{0, 1, 2, 3, 4});
  CHECK(face.tiling().corners().size() == 5);
  CHECK(face.tiling().fit());
}

TEST_CASE("face tiling: the tolerance of positions grows with the coordinates") {
  const Mesh mesh = test::make_triangle();
  CHECK(position_tolerance(test::scaled(mesh, 1024)) == Approx(1024 * position_tolerance(mesh)));
  CHECK(coincide(Vec3(1, 2, 3), Vec3(1, 2, 3), 0));
  CHECK_FALSE(coincide(Vec3(1, 2, 3), Vec3(1, 2, 3.5), 0.25));
}

}  // namespace gvd::test_face_tiling
