// The numbered properties of geodesic/local_update.hpp, over seeded random triangles.
#include <algorithm>
#include <cmath>
#include <optional>

#include "geodesic/marching/local_update.hpp"
#include "gvd/vec.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/random.hpp"
#include "support/stages.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_local_update {

/// The frame of the triangle A = (0, 0), B = (base, 0), D.
UpdateTriangle triangle_of(double base, const Vec2& d) {
  return make_update_triangle(base, d.norm(), (d - Vec2(base, 0)).norm(), base * d.y());
}

UpdateTriangle mirrored(const UpdateTriangle& t) {
  return make_update_triangle(t.base, t.side_b, t.side_a, t.base * t.height);
}

/// The point where the line from p (below the base) to q (above it) crosses the base's line.
double crossing(const Vec2& p, const Vec2& q) { return p.x() + (q.x() - p.x()) * p.y() / (p.y() - q.y()); }

struct Sample {
  double base;
  Vec2 d, source;
};

Sample random_sample(test::Random& random) {
  const double base = random.real(0.2, 3);
  return {base, {random.real(-2, 4), random.real(0.05, 3)}, {random.real(-4, 6), random.real(-4, -0.05)}};
}

bool sees(const Sample& s) {
  const double x = crossing(s.source, s.d);
  return x > 1e-6 && x < s.base - 1e-6;
}

constexpr int kRounds = 20000;

TEST_CASE("the frame of a triangle has its foot and height") {
  const UpdateTriangle t = triangle_of(2, {0.5, 1.5});
  CHECK(t.x == Approx(0.5));
  CHECK(t.height == Approx(1.5));
  CHECK(t.base * t.inverse_base == Approx(1));
  CHECK(triangle_of(2, {-1, 0.5}).x == Approx(-1));  // obtuse at A: the foot lies before it
  CHECK(make_update_triangle(2, 1.5, 0.5, 0).height == 0);
  CHECK(make_update_triangle(2, 1.5, 0.5, 0).x == Approx(1.5));
}

TEST_CASE("(1) both updates are symmetric in A and B") {
  test::Random random(1);
  for (int i = 0; i < kRounds; ++i) {
    const Sample s = random_sample(random);
    const UpdateTriangle t = triangle_of(s.base, s.d);
    const double a = random.real(0, 4), b = random.real(0, 4);
    REQUIRE(update_circle(t, a, b) == Approx(update_circle(mirrored(t), b, a)).epsilon(1e-9));
    REQUIRE(update_planar(t, a, b) == Approx(update_planar(mirrored(t), b, a)).epsilon(1e-9));
    REQUIRE(update_along_edges(t, a, b) == Approx(update_along_edges(mirrored(t), b, a)).epsilon(1e-12));
  }
}

TEST_CASE("(4) no update decreases when a distance grows") {
  test::Random random(7);
  int across = 0;
  for (int i = 0; i < kRounds; ++i) {
    const Sample s = random_sample(random);
    const UpdateTriangle t = triangle_of(s.base, s.d);
    const double a = random.real(0, 4), b = std::max(random.real(0, 4), s.base - a + 1e-9);
    const double more_a = a + random.real(0, 1), more_b = b + random.real(0, 1);
    for (const Front front : {Front::circle, Front::planar}) {
      const double before = update_by(front, t, a, b), after = update_by(front, t, more_a, more_b);
      REQUIRE(after >= before - 1e-12);
      across += before < update_along_edges(t, a, b) ? 1 : 0;
    }
  }
  CHECK(across > kRounds / 5);
}

TEST_CASE(
    "(2) the circle is exact for a planar point source that sees D through A B, and falls back to the edges (3)") {
  test::Random random(2);
  int seen = 0;
  for (int i = 0; i < kRounds; ++i) {
    const Sample s = random_sample(random);
    const UpdateTriangle t = triangle_of(s.base, s.d);
    const double a = s.source.norm(), b = (s.source - Vec2(s.base, 0)).norm();
    const double x = crossing(s.source, s.d);
    if (sees(s)) {
      ++seen;
      REQUIRE(update_circle(t, a, b) == Approx((s.d - s.source).norm()).epsilon(1e-11));
    } else if (x < -1e-6 || x > s.base + 1e-6) {
      REQUIRE(update_circle(t, a, b) == update_along_edges(t, a, b));
    }
  }
  CHECK(seen > kRounds / 20);
  CHECK(seen < kRounds);
}

TEST_CASE("(2) the planar front is exact for a plane wave that passes A B on its way to D") {
  test::Random random(3);
  int seen = 0;
  for (int i = 0; i < kRounds; ++i) {
    const Sample s = random_sample(random);
    const UpdateTriangle t = triangle_of(s.base, s.d);
    const double angle = random.real(-1.5, 1.5);
    const Vec2 way(std::sin(angle), std::cos(angle));
    const double start = 5, a = start, b = start + way.x() * s.base;
    const double x = s.d.x() - s.d.y() * way.x() / way.y();
    if (x > 1e-6 && x < s.base - 1e-6) {
      ++seen;
      REQUIRE(update_planar(t, a, b) == Approx(start + way.dot(s.d)).epsilon(1e-12));
    } else if (x < -1e-6 || x > s.base + 1e-6) {
      REQUIRE(update_planar(t, a, b) == update_along_edges(t, a, b));
    }
  }
  CHECK(seen > kRounds / 20);
  CHECK(seen < kRounds);
}

TEST_CASE("(3) distances that break the triangle inequality fall back to the edges") {
  const UpdateTriangle t = triangle_of(1, {0.4, 0.9});
  for (const auto& [a, b] :
       {std::pair(3.0, 1.5), std::pair(1.5, 3.0), std::pair(0.3, 0.3), std::pair(0.0, 0.0), std::pair(0.0, 5.0)}) {
    CHECK(update_circle(t, a, b) == update_along_edges(t, a, b));
  }
  for (const auto& [a, b] : {std::pair(3.0, 1.5), std::pair(1.5, 3.0), std::pair(0.0, 1.0)}) {
    CHECK(update_planar(t, a, b) == update_along_edges(t, a, b));
  }
}

TEST_CASE("a triangle without height is a line, and its update a finite real path") {
  test::Random random(4);
  for (int i = 0; i < kRounds; ++i) {
    const double base = random.real(0.1, 2), x = random.real(-1, 3);
    const UpdateTriangle t = make_update_triangle(base, std::abs(x), std::abs(x - base), 0);
    const Vec2 source(random.real(-2, 3), random.real(-2, 0));
    const double a = source.norm(), b = (source - Vec2(base, 0)).norm();
    const double straight = (source - Vec2(x, 0)).norm(), edges = update_along_edges(t, a, b);
    const double circle = update_circle(t, a, b), planar = update_planar(t, a, b);
    REQUIRE(std::isfinite(planar));
    REQUIRE(planar <= edges * (1 + 1e-12));
    REQUIRE(circle >= straight * (1 - 1e-7));
    REQUIRE(circle <= edges * (1 + 1e-12));
  }
}

TEST_CASE("no update is above that along the edges") {
  test::Random random(5);
  for (int i = 0; i < kRounds; ++i) {
    const Sample s = random_sample(random);
    const UpdateTriangle t = triangle_of(s.base, s.d);
    const double a = random.real(0, 4), b = random.real(0, 4), edges = update_along_edges(t, a, b);
    REQUIRE(update_circle(t, a, b) <= edges * (1 + 1e-12));
    REQUIRE(update_planar(t, a, b) <= edges * (1 + 1e-12));
  }
}

TEST_CASE("no update is below the smaller distance, except that of circles at an obtuse corner D") {
  test::Random random(6);
  for (int i = 0; i < kRounds; ++i) {
    const Sample s = random_sample(random);
    const UpdateTriangle t = triangle_of(s.base, s.d);
    const double a = random.real(0, 4), b = random.real(0, 4), least = std::min(a, b);
    REQUIRE(update_planar(t, a, b) >= least * (1 - 1e-12));
    const bool obtuse = t.side_a * t.side_a + t.side_b * t.side_b < t.base * t.base;
    REQUIRE(update_circle(t, a, b) >= (obtuse ? least - 0.5 * t.base : least * (1 - 1e-12)));
  }
  // The smallest case: the source is right behind the base, and D right before it.
  const UpdateTriangle flat = triangle_of(2, {1, 0.1});
  CHECK(update_circle(flat, std::hypot(1, 0.1), std::hypot(1, 0.1)) == Approx(0.2));
}

TEST_CASE("updates scale exactly with powers of two") {
  test::Random random(7);
  for (const double scale : {std::ldexp(1.0, -40), std::ldexp(1.0, 40)}) {
    for (int i = 0; i < 1000; ++i) {
      const Sample s = random_sample(random);
      const UpdateTriangle t = triangle_of(s.base, s.d), large = triangle_of(scale * s.base, scale * s.d);
      const double a = random.real(0, 4), b = random.real(0, 4);
      REQUIRE(update_circle(large, scale * a, scale * b) == scale * update_circle(t, a, b));
      REQUIRE(update_planar(large, scale * a, scale * b) == scale * update_planar(t, a, b));
    }
  }
}

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

}  // namespace gvd::test_local_update
