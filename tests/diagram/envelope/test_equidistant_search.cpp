#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "diagram/envelope/source_distances.hpp"
#include "support/catch.hpp"
#include "support/hand_made_field.hpp"
#include "support/random.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_equidistant_search {

FaceSource source(const Vec2& image, double offset) {
  return test::through_side(0, 0, image, {image + Vec2(1, 1), image + Vec2(1, -1)}, offset);
}

std::vector<Vec2> equidistant_points(const std::vector<FaceSource>& a, const std::vector<FaceSource>& b,
                                     const std::vector<FaceSource>& c) {
  std::vector<Vec2> points;
  append_equidistant_points(a, b, c, points);
  return points;
}

double nearest_to(const std::vector<Vec2>& points, const Vec2& p) {
  double least = 1e300;
  for (const Vec2& q : points) least = std::min(least, (q - p).norm());
  return least;
}

TEST_CASE("a point to which three images are equally far is found, whatever their offsets") {
  test::Random random(4);
  const auto anywhere = [&] { return Vec2(random.real(-1, 1), random.real(-1, 1)); };
  for (int round = 0; round < 2000; ++round) {
    const Vec2 p = anywhere();
    std::vector<FaceSource> one[3];
    for (auto& sources : one) {
      const Vec2 image = 3 * anywhere();
      sources.push_back(source(image, 8 - (p - image).norm()));
    }
    INFO("round " << round);
    REQUIRE(nearest_to(equidistant_points(one[0], one[1], one[2]), p) < 1e-7);
  }
}

TEST_CASE("collinear images and equal offsets have finite points") {
  const std::vector<FaceSource> a{source({0, 0}, 0)}, b{source({2, 0}, 0)}, c{source({0, 2}, 0)},
      d{source({3, 0}, 0.5)};
  CHECK(nearest_to(equidistant_points(a, b, c), {1, 1}) < 1e-12);
  for (const Vec2& p : equidistant_points(a, b, d)) CHECK(p.allFinite());
  // On the line half way between the first two, sqrt(1 + y^2) + 1/2 = sqrt(4 + y^2).
  const std::vector<FaceSource> near{source({0, 0}, 0.5)}, other{source({2, 0}, 0.5)}, far{source({3, 0}, 0)};
  bool equal = false;
  for (const Vec2& p : equidistant_points(near, other, far)) {
    const double first = 0.5 + p.norm(), third = (p - Vec2(3, 0)).norm();
    equal = equal || std::abs(first - third) < 1e-12;
  }
  CHECK(equal);
}

TEST_CASE("every triple of sources is solved, and three equal ones have no point") {
  const std::vector<FaceSource> a{source({0, 0}, 0), source({-4, 1}, 0)}, b{source({2, 0}, 0)},
      c{source({0, 2}, 0), source({5, -3}, 0)};
  CHECK(equidistant_points(a, b, c).size() == 8);
  CHECK(equidistant_points(b, b, b).empty());
}

using Sources = std::vector<FaceSource>;
using Generators = std::array<Sources, 3>;

/// Generator g is behind side g of the face: one image for each of `count` openings that divide the side. The images
/// lie round one point, `spread` apart, so that the distances jump by as much from opening to opening.
Generators behind_sides(const FaceLayout& face, test::Random& random, int count, double spread) {
  Generators all;
  for (int g = 0; g < 3; ++g) {
    const auto i = static_cast<std::size_t>(g);
    const Vec2 from = face.corner[i], to = face.corner[(i + 1) % 3];
    const Vec2 outwards(face.side(g).y(), -face.side(g).x());
    const Vec2 behind = from + random.real(0.2, 0.8) * (to - from) + random.real(0.2, 2) * outwards;
    const double offset = random.real(0, 0.3);
    for (int k = 0; k < count; ++k) {
      const Vec2 image = behind + spread * Vec2(random.real(-1, 1), random.real(-1, 1));
      const Vec2 begin = from + (to - from) * k / count, end = from + (to - from) * (k + 1) / count;
      all[i].push_back(test::through_side(g, g, image, {begin, end}, offset));
    }
  }
  return all;
}

/// The points of the face that are equally far from the three generators by straight paths through openings, by all
/// triples.
std::vector<Vec2> all_equidistant_points(const FaceLayout& face, const Generators& g) {
  std::vector<Vec2> points, equal;
  append_equidistant_points(g[0], g[1], g[2], points);
  for (const Vec2& p : points) {
    const Bary bary = face.bary(p);
    if (*std::min_element(bary.begin(), bary.end()) < 0) continue;
    double least = std::numeric_limits<double>::infinity(), most = 0;
    for (const Sources& sources : g) {
      const double distance = nearest(sources, p).path.distance;
      least = std::min(least, distance);
      most = std::max(most, distance);
    }
    if (most - least < 1e-12) equal.push_back(p);
  }
  return equal;
}

TEST_CASE("the search finds the points equally far from three generators that all triples give") {
  const FaceLayout face(test::make_triangle(), FaceId(0));
  test::Random random(7);
  EquidistantSearch search;
  std::size_t expected = 0;
  for (int round = 0; round < 100; ++round) {
    const Generators g = behind_sides(face, random, 1 + random.below(30), round % 2 == 0 ? 1e-3 : 0.2);
    const auto& found = search.find(face, g[0], g[1], g[2]);
    for (const Vec2& p : all_equidistant_points(face, g)) {
      ++expected;
      INFO("round " << round);
      const bool is_found =
          std::any_of(found.begin(), found.end(), [&](const Vec2& q) { return (p - q).norm() < 1e-9; });
      REQUIRE(is_found);
    }
  }
  CHECK(expected > 20);
}

TEST_CASE("hundreds of sources of each generator leave few candidates") {
  const FaceLayout face(test::make_triangle(), FaceId(0));
  test::Random random(8);
  EquidistantSearch search;
  for (const double spread : {1e-9, 1e-5, 1e-2}) {
    const Generators g = behind_sides(face, random, 500, spread);
    INFO("spread " << spread);
    CHECK(search.find(face, g[0], g[1], g[2]).size() < 5000);  // all triples have 250 million
  }
}

TEST_CASE("where all paths tie everywhere, the search ends") {
  const FaceLayout face(test::make_triangle(), FaceId(0));
  const Sources tied(300, test::from_corner(0, 0, face.corner[0], 1));
  EquidistantSearch search;
  CHECK(search.find(face, tied, tied, tied).size() < 5000);
  CHECK(search.find(face, tied, tied, {}).empty());
}

}  // namespace gvd::test_equidistant_search
