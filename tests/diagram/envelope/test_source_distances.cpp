#include <algorithm>
#include <cmath>

#include "diagram/envelope/source_distances.hpp"
#include "support/catch.hpp"
#include "support/hand_made_field.hpp"
#include "support/random.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_source_distances {

using test::from_corner;
using test::HandMadeField;
using test::through_side;

const GeneratorId kA(0), kB(1), kC(2);
const Vec2 k0(0, 0), k1(2, 0), k2(0.5, 1.5);  // corners of test::make_triangle, in its layout

/// One generator behind each side, through all of it.
std::vector<FaceSource> three_behind_sides(double offset_a, double offset_b, double offset_c) {
  return {through_side(0, 0, {0.9, -0.4}, {k0, k1}, offset_a), through_side(1, 1, {1.8, 1.1}, {k1, k2}, offset_b),
          through_side(2, 2, {-0.3, 0.9}, {k2, k0}, offset_c)};
}

TEST_CASE("the path is straight where the source sees the point, and bends round an end of the opening elsewhere") {
  const HandMadeField field({through_side(0, 0, {1, -1}, {{0.9, 0}, {1.1, 0}}, 0.25)});
  SourceDistances distances(field);
  distances.enter(test::make_triangle(), FaceId(0));
  CHECK(distances.nearest(kA, {1, 0.5}).distance == Approx(0.25 + 1.5).epsilon(1e-15));
  const auto round_left = distances.nearest(kA, {0.5, 0.3}), round_right = distances.nearest(kA, {1.5, 0.2});
  CHECK(round_left.distance == Approx(0.25 + std::hypot(0.1, 1) + std::hypot(0.4, 0.3)).epsilon(1e-15));
  CHECK((round_left.from - Vec2(0.9, 0)).norm() == 0);
  CHECK(round_right.distance == Approx(0.25 + std::hypot(0.1, 1) + std::hypot(0.4, 0.2)).epsilon(1e-15));
  CHECK((round_right.from - Vec2(1.1, 0)).norm() == 0);
}

TEST_CASE("the distance of a generator is that over its own sources, the nearest of them") {
  const HandMadeField field({through_side(1, 0, {1, -0.1}, {k0, k1}, 0), through_side(0, 0, {1, -1}, {k0, k1}, 0.5),
                             from_corner(0, 2, k2, 0.7), through_side(0, 1, {1.8, 1.1}, {k1, k2}, 2)});
  SourceDistances distances(field);
  distances.enter(test::make_triangle(), FaceId(0));
  test::Random random(1);
  for (int i = 0; i < 200; ++i) {
    const double u = random.real(0, 1), v = random.real(0, 1 - u);
    const Bary bary{u, v, 1 - u - v};
    const Vec2 p = u * k0 + v * k1 + (1 - u - v) * k2;
    const double expected =
        std::min({0.5 + (p - Vec2(1, -1)).norm(), 0.7 + (p - k2).norm(), 2 + (p - Vec2(1.8, 1.1)).norm()});
    REQUIRE(distances.at(kA, bary) == Approx(expected).epsilon(1e-14));
  }
  CHECK(std::isinf(distances.at(kC, {1, 0, 0})));
  // A generator without a source has no equidistant point.
  const Bary centre{1.0 / 3, 1.0 / 3, 1.0 / 3};
  CHECK_FALSE(distances.equidistant(kC, kA, kB, centre).has_value());
  CHECK_FALSE(distances.equidistant(kA, kB, kC, centre).has_value());
}

TEST_CASE("the entry is where the path crosses the side") {
  const HandMadeField field({through_side(0, 0, {1, -1}, {{0.2, 0}, {1.8, 0}}, 0), from_corner(1, 2, k2, 0.1),
                             through_side(2, 1, {2, 1.5}, {k1, k2}, 0)});
  SourceDistances distances(field);
  const Mesh mesh = test::make_triangle();
  distances.enter(mesh, FaceId(0));
  const Vec2 p(0.8, 0.25);
  const auto entry = distances.entry(kA, distances.layout().bary(p));
  REQUIRE(entry);
  // The line from (1, -1) to (0.8, 0.25) crosses y = 0 after 1 / 1.25 of its length; the side is 2 long.
  CHECK(*entry == Approx((1 - 0.2 * (1 / 1.25)) / 2).epsilon(1e-14));
  CHECK(*distances.entry(kB, distances.layout().bary(p)) == 2);
  const auto other = distances.entry(kC, distances.layout().bary(p));
  REQUIRE(other);
  const Vec2 through = k1 + (*other - 1) * (k2 - k1), way = Vec2(2, 1.5) - p;
  CHECK(std::abs(way.x() * (through - p).y() - way.y() * (through - p).x()) < 1e-14);
  CHECK_FALSE(distances.entry(GeneratorId(9), distances.layout().bary(p)));
}

TEST_CASE("Newton's method finds the branch point from most starts in the face, with and without offsets") {
  test::Random random(4);
  int found = 0;
  for (int round = 0; round < 300; ++round) {
    INFO("round " << round);
    const bool plain = round % 3 == 0;
    const auto offset = [&] { return plain ? 0 : random.real(0, 0.25); };
    const auto sources = three_behind_sides(offset(), offset(), offset());
    const HandMadeField field(sources);
    SourceDistances distances(field);
    distances.enter(test::make_triangle(), FaceId(0));
    const double u = random.real(0, 1), v = random.real(0, 1 - u);
    const auto bary = distances.equidistant(kA, kB, kC, {u, v, 1 - u - v});
    if (!bary) continue;
    ++found;
    const Vec2 p = (*bary)[0] * k0 + (*bary)[1] * k1 + (*bary)[2] * k2;
    const auto straight = [&](std::size_t i) { return sources[i].offset + (p - sources[i].image).norm(); };
    if (*std::min_element(bary->begin(), bary->end()) < 0) continue;
    REQUIRE(straight(0) == Approx(straight(1)).epsilon(1e-12));
    REQUIRE(straight(0) == Approx(straight(2)).epsilon(1e-12));
  }
  CHECK(found >= 270);  // 285; assembly starts from several places
}

TEST_CASE("a branch point lies inside, has its cells counter-clockwise, and no generator is nearer") {
  auto sources = three_behind_sides(0, 0.05, 0.1);
  const Mesh mesh = test::make_triangle();
  const HandMadeField field(sources);
  SourceDistances distances(field);
  distances.enter(mesh, FaceId(0));
  const auto p = distances.equidistant(kA, kB, kC, {0.3, 0.3, 0.4});
  REQUIRE(p);
  CHECK(distances.is_branch_point(kA, kB, kC, *p));
  CHECK(distances.is_branch_point(kB, kC, kA, *p));
  CHECK_FALSE(distances.is_branch_point(kB, kA, kC, *p));
  CHECK_FALSE(distances.is_branch_point(kA, kB, kC, {-0.1, 0.5, 0.6}));
  CHECK_FALSE(distances.is_branch_point(kA, kB, kC, {0, 0.5, 0.5}));

  const double radius = distances.at(kA, *p);
  for (const auto& [distance, expected] : {std::pair(0.99, false), std::pair(1.0, true), std::pair(1.01, true)}) {
    const Vec2 at_p = distances.layout().at(*p);
    auto four = sources;
    four.push_back(from_corner(3, 0, k0, distance * radius - at_p.norm()));
    const HandMadeField with_fourth(four);
    SourceDistances other(with_fourth);
    other.enter(mesh, FaceId(0));
    CHECK(other.is_branch_point(kA, kB, kC, *p) == expected);
  }
}

TEST_CASE("three generators with parallel bisectors have no branch point") {
  // All on one line, behind one side: their bisectors are parallel.
  const HandMadeField field({through_side(0, 0, {0.5, -1}, {k0, k1}, 0), through_side(1, 0, {1, -1}, {k0, k1}, 0),
                             through_side(2, 0, {1.5, -1}, {k0, k1}, 0)});
  SourceDistances distances(field);
  distances.enter(test::make_triangle(), FaceId(0));
  const auto p = distances.equidistant(kA, kB, kC, {0.3, 0.3, 0.4});
  CHECK_FALSE((p && distances.is_branch_point(kA, kB, kC, *p)));
}

TEST_CASE("the equidistant points contain the branch point, and are none where a generator has no source") {
  const HandMadeField field(three_behind_sides(0, 0, 0));
  SourceDistances distances(field);
  distances.enter(test::make_triangle(), FaceId(0));
  const auto p = distances.equidistant(kA, kB, kC, {0.3, 0.3, 0.4});
  REQUIRE(p);
  const auto points = distances.equidistant_points(kA, kB, kC);
  CHECK(std::any_of(points.begin(), points.end(), [&](const auto& q) { return std::abs(q[0] - (*p)[0]) < 1e-9; }));
  CHECK(distances.equidistant_points(kA, kB, GeneratorId(7)).empty());
}

TEST_CASE("the error of a crossing grows as its two generators approach each other") {
  for (const double apart : {1e-2, 1e-5, 1e-8}) {
    CAPTURE(apart);
    const HandMadeField field(
        {through_side(0, 0, {1 - apart / 2, -1}, {k0, k1}, 0), through_side(1, 0, {1 + apart / 2, -1}, {k0, k1}, 0)});
    SourceDistances distances(field);
    distances.enter(test::make_triangle(), FaceId(0));
    const double error = distances.crossing_error({CrossingId(0), 0, 0.5, kA, kB});
    // The difference of the distances changes by `apart` a unit of length, and the side is 2 long.
    CHECK(error >= 1e-14 / (2 * apart));
    CHECK(error <= 1e-13 / (2 * apart));
  }
}

TEST_CASE("symbolic offsets add to all distances of a second view, and change nothing in the first one") {
  const HandMadeField field(three_behind_sides(0, 0.05, 0.1));
  SourceDistances distances(field), with_offsets(field);
  distances.enter(test::make_triangle(), FaceId(0));
  const Bary centre{0.3, 0.3, 0.4};
  const double a = distances.at(kA, centre), c = distances.at(kC, centre);
  with_offsets.enter_with_offsets(distances, {0.25});
  CHECK(with_offsets.at(kA, centre) == a);
  CHECK(with_offsets.at(kC, centre) == Approx(c + 0.5).epsilon(1e-15));
  CHECK(distances.at(kC, centre) == c);
  with_offsets.enter(test::make_triangle(), FaceId(0));
  CHECK(with_offsets.at(kC, centre) == c);
}

}  // namespace gvd::test_source_distances
