#include <cmath>

#include "geodesic/marching/auxiliary_distance.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/random.hpp"
#include "support/stages.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_auxiliary_distance {

constexpr std::array<Front, 2> kFronts{Front::circle, Front::planar};

/// The shape of the triangle (0, 0), (2, 0), apex.
FaceShape shape_of(const Vec2& apex) {
  return test::make_mesh({{0, 0, 0}, {2, 0, 0}, {apex.x(), apex.y(), 0}}, {{0, 1, 2}}).shape(FaceId(0));
}

TEST_CASE("a face without area has halves without height, and finite distances") {
  for (const double x : {0.5, 1.0, 3.0}) {
    const FaceShape shape = shape_of({x, 0});
    for (std::size_t side = 0; side < 3; ++side) {
      const MedianHalves halves = make_median_halves(shape, side);
      CHECK(halves.at_a.height == Approx(0).margin(1e-12));
      for (const Front front : kFronts) CHECK(std::isfinite(auxiliary_distance(halves, {1, 1, 1}, side, front)));
    }
  }
}

TEST_CASE("the halves share the median, and each has half of the area") {
  test::Random random(1);
  for (int i = 0; i < 200; ++i) {
    const Vec2 apex(random.real(-1, 3), random.real(0.1, 2));
    const FaceShape shape = shape_of(apex);
    const MedianHalves halves = make_median_halves(shape, 0);
    REQUIRE(halves.at_a.side_a == Approx((apex - Vec2(1, 0)).norm()));
    REQUIRE(halves.at_b.side_a == halves.at_a.side_a);
    REQUIRE(halves.at_a.base * halves.at_a.height == Approx(0.5 * shape.twice_area));
    REQUIRE(halves.at_b.base * halves.at_b.height == Approx(0.5 * shape.twice_area));
  }
}

TEST_CASE("the distance is at most that along the median, and along the halves of the edge") {
  test::Random random(2);
  for (int i = 0; i < 500; ++i) {
    const Vec2 apex(random.real(-1, 3), random.real(0.1, 2));
    const MedianHalves halves = make_median_halves(shape_of(apex), 0);
    const std::array<double, 3> d{random.real(0, 3), random.real(0, 3), random.real(0, 3)};
    const double edges = std::min({d[0] + 1, d[1] + 1, d[2] + (apex - Vec2(1, 0)).norm()});
    for (const Front front : kFronts) REQUIRE(auxiliary_distance(halves, d, 0, front) <= edges * (1 + 1e-12));
  }
}

TEST_CASE(
    "with circle fronts an auxiliary distance is exact on a flat grid where the front enters through the face's other "
    "edges") {
  const Mesh mesh = test::make_grid(12, 9);
  const VertexId from(4 * 13 + 6);
  for (const Front front : kFronts) {
    const test::Stages stages(mesh, {vertex_point(mesh, from)}, front);
    int exact = 0, all = 0;
    for (int i = 0; i < mesh.face_count(); ++i) {
      stages.table().for_each(FaceId(i), [&](const TableEntry& entry) {
        const auto d = stages.table().corner_distances(entry);
        for (int side = 0; side < 3; ++side) {
          const HalfedgeId h = Mesh::halfedge(FaceId(i), side);
          const Vec3 middle = 0.5 * (mesh.position(mesh.from(h)) + mesh.position(mesh.to(h)));
          const double straight = (middle - mesh.position(from)).norm();
          const auto k = static_cast<std::size_t>(side);
          const double found = auxiliary_distance(make_median_halves(mesh.shape(FaceId(i)), k), d, k, front);
          REQUIRE(found >= straight - 1e-8);
          REQUIRE(found <= d[(k + 2) % 3] + std::sqrt(5) / 2 + 1e-12);  // from the opposite corner along the median
          exact += found <= straight + 1e-8 ? 1 : 0;
          ++all;
        }
      });
    }
    if (front == Front::circle) CHECK(exact > all / 2);
  }
}

}  // namespace gvd::test_auxiliary_distance
