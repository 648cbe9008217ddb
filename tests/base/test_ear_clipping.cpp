#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <queue>
#include <set>
#include <vector>

#include "base/ear_clipping.hpp"
#include "base/plane.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace gvd::test_ear_clipping {

using Triangle = std::array<std::size_t, 3>;

double twice_polygon_area(const std::vector<Vec2>& polygon) {
  return twice_signed_area(polygon.size(), [&](std::size_t i) { return polygon[i]; });
}

/// Each has a positive area, together they have the polygon's, and they meet along whole sides: so none overlap.
void check_triangles(const std::vector<Vec2>& polygon, const std::vector<Triangle>& triangles) {
  const std::size_t n = polygon.size();
  REQUIRE(triangles.size() == n - 2);
  double sum = 0, least = std::numeric_limits<double>::infinity();
  std::set<std::pair<std::size_t, std::size_t>> open;
  for (std::size_t i = 0; i < n; ++i) open.emplace((i + 1) % n, i);
  for (const Triangle& t : triangles) {
    const double area = twice_signed_area(polygon[t[0]], polygon[t[1]], polygon[t[2]]);
    least = std::min(least, area);
    sum += area;
    for (std::size_t i = 0; i < 3; ++i) {
      if (open.erase({t[(i + 1) % 3], t[i]}) == 0) REQUIRE(open.emplace(t[i], t[(i + 1) % 3]).second);
    }
  }
  CHECK(open.empty());
  CHECK(least > 0);
  CHECK(sum == Approx(twice_polygon_area(polygon)));
}

/// What triangulate_plane_polygon does, by a look at all corners for each of all corners: n times n squared.
class SlowEarClipper {
 public:
  explicit SlowEarClipper(const std::vector<Vec2>& corners) : corners_(corners), left_(corners.size()) {
    std::iota(left_.begin(), left_.end(), std::size_t{0});
  }

  std::vector<Triangle> run() {
    std::vector<Triangle> triangles;
    for (; left_.size() > 3; left_.erase(left_.begin() + std::ptrdiff_t(best()))) triangles.push_back(around(best()));
    triangles.push_back(around(1));
    return triangles;
  }

 private:
  Triangle around(std::size_t i) const {
    return {left_[(i + left_.size() - 1) % left_.size()], left_[i], left_[(i + 1) % left_.size()]};
  }

  double shape(std::size_t i) const {
    constexpr double kOnLine = 1e-12;
    const Triangle t = around(i);
    const Vec2 &a = corners_[t[0]], &b = corners_[t[1]], &c = corners_[t[2]];
    const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    const double slack = kOnLine * longest;
    const bool is_ear = std::none_of(left_.begin(), left_.end(), [&](std::size_t k) {
      const Vec2& p = corners_[k];
      const bool is_own = p == a || p == b || p == c;
      return !is_own && twice_signed_area(a, b, p) >= -slack && twice_signed_area(b, c, p) >= -slack &&
             twice_signed_area(c, a, p) >= -slack;
    });
    const double area = twice_signed_area(a, b, c);
    return is_ear && area > slack ? area / longest : area - 4;
  }

  std::size_t best() const {
    std::size_t best = 0;
    for (std::size_t i = 1; i < left_.size(); ++i) {
      if (shape(i) > shape(best)) best = i;
    }
    return best;
  }

  const std::vector<Vec2>& corners_;
  std::vector<std::size_t> left_;
};

/// A polygon round a middle, with corners at random distances from it.
std::vector<Vec2> make_star(int corners, double least, unsigned seed) {
  test::Random random(seed);
  std::vector<Vec2> polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners, radius = random.real(least, 0.5);
    polygon.emplace_back(0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle));
  }
  return polygon;
}

/// Two parts of the triangle (0,0) (1,0) (0,1), above and below of an arc with `corners` corners.
std::array<std::vector<Vec2>, 2> make_parts_at_arc(int corners, double height) {
  std::vector<Vec2> below{{0, 0}, {1, 0}}, above{{0, 1}};
  for (int i = 0; i <= corners; ++i) {
    const double t = double(i) / corners;
    const double x = 0.75 * (1 - t);
    below.emplace_back(x, 0.25 + height * t * (1 - t));
    above.emplace_back(0.75 - x, 0.25 + height * t * (1 - t));
  }
  return {below, above};
}

TEST_CASE("polygons: fewer than three corners have no triangle, three one") {
  CHECK(triangulate_plane_polygon({}).empty());
  CHECK(triangulate_plane_polygon({{0, 0}}).empty());
  CHECK(triangulate_plane_polygon({{0, 0}, {1, 0}}).empty());
  CHECK(triangulate_plane_polygon({{0, 0}, {1, 0}, {0, 1}}) == std::vector<Triangle>{{0, 1, 2}});
}

TEST_CASE("polygons: corners on a line become corners of triangles with an area") {
  const std::vector<Vec2> square{{0, 0}, {0.25, 0}, {0.5, 0}, {1, 0}, {1, 0.5}, {1, 1}, {0, 1}, {0, 0.5}};
  check_triangles(square, triangulate_plane_polygon(square));
}

TEST_CASE("polygons: the ears are those that a look at all corners finds") {
  for (unsigned seed = 1; seed <= 30; ++seed) {
    for (const int corners : {4, 5, 9, 16, 33}) {
      for (const double least : {0.01, 0.3, 0.5}) {
        CAPTURE(seed, corners, least);
        std::vector<Vec2> polygon = make_star(corners, least, seed);
        CHECK(triangulate_plane_polygon(polygon) == SlowEarClipper(polygon).run());
        // Folded, as rounding may leave one.
        std::swap(polygon[1], polygon[2]);
        CHECK(triangulate_plane_polygon(polygon) == SlowEarClipper(polygon).run());
      }
    }
  }
}

TEST_CASE("polygons: thousands of corners on an arc, round and hollow, bent much and hardly") {
  for (const double height : {0.4, -0.4, 1e-3, -1e-3}) {
    for (const std::vector<Vec2>& polygon : make_parts_at_arc(5000, height)) {
      CAPTURE(height, polygon.size());
      check_triangles(polygon, triangulate_plane_polygon(polygon));
    }
  }
}

TEST_CASE("polygons: thousands of corners, in a star, in the teeth of a comb, in a spiral") {
  check_triangles(make_star(5001, 0.2, 1), triangulate_plane_polygon(make_star(5001, 0.2, 1)));

  std::vector<Vec2> comb{{1, 0}, {1, 1}};
  for (int i = 2000; i > 0; --i) {
    comb.emplace_back((i - 0.5) / 2000, 0.1);
    comb.emplace_back((i - 1.0) / 2000, 0.9);
  }
  comb.emplace_back(0, 0);
  check_triangles(comb, triangulate_plane_polygon(comb));

  std::vector<Vec2> spiral;
  for (const double width : {0.0, 0.02}) {
    std::vector<Vec2> side;
    for (int i = 0; i <= 2000; ++i) {
      const double angle = 0.01 * i, radius = 0.1 + 0.01 * angle + width;
      side.emplace_back(0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle));
    }
    if (width == 0) std::reverse(side.begin(), side.end());
    spiral.insert(spiral.end(), side.begin(), side.end());
  }
  check_triangles(spiral, triangulate_plane_polygon(spiral));
}

TEST_CASE("polygon ring: at first every corner is left, between its neighbours") {
  const PolygonRing ring(4);
  CHECK(ring.corner_count() == 4);
  CHECK(ring.left_count() == 4);
  CHECK(ring.first_left() == 0);
  CHECK(ring.triangle(0) == std::array<std::size_t, 3>{3, 0, 1});
  CHECK(ring.triangle(3) == std::array<std::size_t, 3>{2, 3, 0});
}

TEST_CASE("polygon ring: a removed corner links its neighbours and makes their triangles new") {
  PolygonRing ring(5);
  ring.remove(0);
  CHECK_FALSE(ring.is_left(0));
  CHECK(ring.first_left() == 1);
  CHECK(ring.left_count() == 4);
  CHECK(ring.after(4) == 1);
  CHECK(ring.before(1) == 4);
  CHECK(ring.version(1) == 1);
  CHECK(ring.version(4) == 1);
  CHECK(ring.version(2) == 0);
  ring.remove(1);
  CHECK(ring.triangle(2) == std::array<std::size_t, 3>{4, 2, 3});
  CHECK(ring.version(4) == 2);
}

TEST_CASE("polygon ring: a candidate is outdated once its corner or a neighbour is gone") {
  PolygonRing ring(5);
  const EarCandidate at_1 = ring.candidate(1, 0.5), at_2 = ring.candidate(2, 0.5), at_4 = ring.candidate(4, 0.5);
  CHECK(ring.is_current(at_1));
  ring.remove(1);
  CHECK_FALSE(ring.is_current(at_1));
  CHECK_FALSE(ring.is_current(at_2));
  CHECK(ring.is_current(at_4));
  CHECK(ring.is_current(ring.candidate(2, 0.5)));
}

TEST_CASE("ear candidates: the best quality comes first, of equal ones the first corner") {
  std::priority_queue<EarCandidate> queue;
  for (const EarCandidate& ear : {EarCandidate{0.5, 3, 0}, {0.7, 4, 0}, {0.5, 1, 0}, {-2, 0, 0}}) queue.push(ear);
  for (const std::size_t expected : {4, 1, 3, 0}) {
    CHECK(queue.top().corner == expected);
    queue.pop();
  }
}

}  // namespace gvd::test_ear_clipping
