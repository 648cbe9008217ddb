#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "base/plane.hpp"
#include "diagram/envelope/refine_arcs.hpp"
#include "support/catch.hpp"
#include "support/hand_made_field.hpp"
#include "support/random.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_refine_arcs {

using test::HandMadeField;
using test::through_side;

const GeneratorId kA(0), kB(1);
const Vec2 k0(0, 0), k1(2, 0), k2(0.5, 1.5);  // corners of test::make_triangle, in its layout

/// The arc between A, on its left, and B, from the point where they are equally far on side `from` to that on side
/// `to`.
struct RefinedArc {
  HandMadeField field;
  SourceDistances distances{field};
  Bary begin{}, end{};
  std::vector<Bary> inner;

  RefinedArc(std::vector<FaceSource> sources, int from, int to, double tolerance) : field(std::move(sources)) {
    distances.enter(test::make_triangle(), FaceId(0));
    begin = equidistant_on(from);
    end = equidistant_on(to);
    FaceArc arc;
    arc.left = kA;
    arc.right = kB;
    ArcRefiner(tolerance).refine(distances, arc, begin, end, inner);
  }

  double error(const Bary& p) const { return distances.at(kA, p) - distances.at(kB, p); }

  /// By bisection along the side, where the nearer of the two has to change once.
  Bary equidistant_on(int side) const {
    const auto at = [side](double t) {
      Bary p{0, 0, 0};
      p[std::size_t(side)] = 1 - t;
      p[std::size_t((side + 1) % 3)] = t;
      return p;
    };
    double low = 0, high = 1;
    const bool rising = error(at(0)) < 0;
    REQUIRE((error(at(1)) < 0) != rising);
    for (int i = 0; i < 100; ++i) {
      const double middle = 0.5 * (low + high);
      ((error(at(middle)) < 0) == rising ? low : high) = middle;
    }
    return at(low);
  }

  std::vector<Vec2> polyline() const {
    std::vector<Vec2> points{distances.layout().at(begin)};
    for (const auto& p : inner) points.push_back(distances.layout().at(p));
    points.push_back(distances.layout().at(end));
    return points;
  }

  /// The largest distance of the polyline from the bisector: the error by its gradient, at many points.
  double farthest() const {
    double worst = 0;
    const auto points = polyline();
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      for (int k = 1; k < 32; ++k) {
        const Vec2 p = points[i] + k / 32.0 * (points[i + 1] - points[i]);
        const auto a = distances.nearest(kA, p), b = distances.nearest(kB, p);
        const Vec2 gradient = (p - a.from).normalized() - (p - b.from).normalized();
        worst = std::max(worst, std::abs(a.distance - b.distance) / gradient.norm());
      }
    }
    return worst;
  }
};

/// A hyperbola from side 0 to side 2.
std::vector<FaceSource> hyperbola() {
  return {through_side(0, 2, {-0.3, 0.4}, {k2, k0}, 0.4), through_side(1, 1, {1.9, 0.7}, {k1, k2}, 0)};
}

/// A hyperbola that is a tenth of its chord's length away from the chord.
std::vector<FaceSource> strong_hyperbola() {
  return {through_side(0, 2, {-0.356, 1.074}, {k2, k0}, 0), through_side(1, 0, {0.167, -0.0337}, {k0, k1}, 0.956)};
}

TEST_CASE("the inner points of a hyperbola lie on it") {
  for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
    const RefinedArc arc(hyperbola(), 0, 2, tolerance);
    for (const auto& p : arc.inner) {
      // As near as a hundredth of the tolerance; the gradient of the difference is at most 2.
      REQUIRE(std::abs(arc.error(p)) <= 2e-2 * tolerance + 1e-14);
      for (const double coordinate : p) REQUIRE(coordinate >= 0);
    }
  }
}

TEST_CASE("segments are within the tolerance of the bisector, and there are not many more than necessary") {
  std::size_t before = 0;
  for (const double tolerance : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
    INFO(tolerance);
    const RefinedArc arc(hyperbola(), 0, 2, tolerance);
    CHECK(arc.farthest() <= tolerance);
    CHECK(arc.inner.size() >= before);
    // A chord's distance falls with the square of its length, and halving costs a factor of two at most.
    CHECK(double(arc.inner.size()) <= 2 + 4 * std::sqrt(1 / tolerance));
    before = arc.inner.size();
  }
  CHECK(before > 50);
}

TEST_CASE("the inner points are in order along the arc") {
  const RefinedArc arc(hyperbola(), 0, 2, 1e-5);
  const auto points = arc.polyline();
  const Vec2 along = (points.back() - points.front()).normalized();
  for (std::size_t i = 0; i + 1 < points.size(); ++i) REQUIRE((points[i + 1] - points[i]).dot(along) > 0);
}

TEST_CASE("with equal offsets the bisector is straight, and gets no inner points") {
  for (const double offset : {0.0, 0.3}) {
    const RefinedArc arc(
        {through_side(0, 2, {-0.3, 0.4}, {k2, k0}, offset), through_side(1, 1, {1.9, 0.7}, {k1, k2}, offset)}, 0, 1,
        1e-10);
    CHECK(arc.inner.empty());
  }
}

TEST_CASE("a bisector with a corner, where the nearest source of a generator changes, is traced on both sides of it") {
  // Side 0, y = 0: the left one sees the left half and the right one the right half of what lies behind it.
  const auto sources = [] {
    return std::vector{through_side(1, 1, {1.4, 1.3}, {k1, k2}, 0), through_side(0, 0, {0.4, -0.5}, {k0, k1}, 0),
                       through_side(0, 0, {1.6, -0.2}, {k0, k1}, 0.1)};
  };
  const RefinedArc rough(sources(), 1, 2, 1e-2), fine(sources(), 1, 2, 1e-6);
  CHECK(rough.farthest() <= 1e-2);
  CHECK(fine.farthest() <= 1e-6);
  CHECK(!fine.inner.empty());
}

TEST_CASE("corners are found wherever paths change, also where the quarters of a segment are near enough") {
  test::Random random(3);
  int checked = 0;
  for (int round = 0; round < 400; ++round) {
    // A's openings divide side 0. Its distances are continuous where one ends and the next one begins.
    std::vector<FaceSource> sources{through_side(1, 1, {1.4, 1.3}, {k1, k2}, 0.2)};
    double from = 0;
    Vec2 image(random.real(0.3, 0.7), -random.real(0.3, 1));
    double offset = 0;
    for (int k = random.below(6); k >= 0; --k) {
      const double to = k == 0 ? 2 : random.real(from, 2);
      sources.push_back(through_side(0, 0, image, {Vec2(from, 0), Vec2(to, 0)}, offset));
      const Vec2 next = image + Vec2(random.real(0, 0.3), random.real(-0.2, 0.2));
      offset += (Vec2(to, 0) - image).norm() - (Vec2(to, 0) - next).norm();
      image = next;
      from = to;
    }
    // The bisector parts corner 2 from the other two, and crosses each of the sides there once.
    const auto is_nearer_to_a = [&](const Vec2& p) {
      return nearest(std::span(sources).subspan(1), p).path.distance < sources[0].distance(p);
    };
    if (!is_nearer_to_a(k0) || !is_nearer_to_a(k1) || is_nearer_to_a(k2)) continue;
    ++checked;
    const double tolerance = std::pow(10, -random.real(2, 5));
    const RefinedArc arc(sources, 1, 2, tolerance);
    INFO("round " << round << ", tolerance " << tolerance);
    REQUIRE(arc.farthest() <= tolerance);
  }
  CHECK(checked > 100);
}

TEST_CASE("a source that sees the bisector but nothing near its chord is used") {
  const auto points = RefinedArc(strong_hyperbola(), 2, 0, 1e-3).polyline();
  const Vec2 chord = points.back() - points.front(), along = chord.normalized();
  const auto height = [&](const Vec2& p) { return std::abs(cross(along, p - points.front())); };
  const Vec2 apex = *std::max_element(points.begin(), points.end(),
                                      [&](const Vec2& p, const Vec2& q) { return height(p) < height(q); });
  REQUIRE(height(apex) > 0.1 * chord.norm());
  // A second image of A, from which the apex is seen through a slit in side 1, and no point near the chord.
  const Vec2 image = apex + 2 * along, side = k2 - k1;
  const auto on_side = [&](double turn) {
    const Vec2 ray = -along + turn * turned_left(-along);
    return Vec2(k1 + cross(image - k1, ray) / cross(side, ray) * side);
  };
  auto sources = strong_hyperbola();
  const double clearance = 0.01, known = sources[0].distance(apex);
  sources.push_back(
      through_side(0, 1, image, {on_side(0.02), on_side(-0.02)}, known - clearance - (apex - image).norm()));
  const RefinedArc arc(sources, 2, 0, 1e-4);
  REQUIRE(arc.distances.nearest(kA, apex).distance < known - 0.9 * clearance);
  CHECK(arc.farthest() <= 1e-4);
}

TEST_CASE("a generator whose sources see nothing of the arc is used by its paths round the ends of their openings") {
  // A sees the corner k0 alone, past the slit from (0.05, 0) to (0.1, 0).
  const RefinedArc arc(
      {through_side(0, 0, {1.5, -0.05}, {{0.05, 0}, {0.1, 0}}, 0), through_side(1, 1, {1.9, 0.7}, {k1, k2}, 1.2)}, 0, 2,
      1e-4);
  CHECK_FALSE(arc.inner.empty());
  CHECK(arc.farthest() <= 1e-4);
}

/// What two images with offsets give at p.
BisectorSample sample(const Vec2& p, const Vec2& left, double left_offset, const Vec2& right, double right_offset) {
  return {p, {nullptr, {left_offset + (p - left).norm(), left}}, {nullptr, {right_offset + (p - right).norm(), right}}};
}

TEST_CASE("a generator without a path makes a sample unknown") {
  BisectorSample s = sample({0, 0}, {-1, 0}, 0, {1, 0}, 0);
  CHECK(s.is_known());
  s.right.path.distance = std::numeric_limits<double>::infinity();
  CHECK_FALSE(s.is_known());
}

TEST_CASE("at an image the direction is zero, and nothing else fails") {
  const BisectorSample s = sample({-1, 0}, {-1, 0}, 0, {1, 0}, 0);
  CHECK(s.gradient == Vec2(1, 0));
  CHECK(s.error() == -2);
}

TEST_CASE("halfway between two images: no error, and the bisector has the left one on its left") {
  const BisectorSample s = sample({0, 0.5}, {-1, 0.5}, 0.25, {1, 0.5}, 0.25);
  CHECK(s.error() == 0);
  CHECK(s.gradient == Vec2(2, 0));
  CHECK(s.tangent() == Vec2(0, 2));
  CHECK(s.distance_to_bisector({-1, 0}, 1e-12) == 0);
}

TEST_CASE("the distance to the bisector leads to a point that is equally far from both images") {
  test::Random random(1);
  int found = 0;
  for (int round = 0; round < 1000; ++round) {
    const Vec2 left(-random.real(0.5, 2), random.real(-1, 1)), right(random.real(0.5, 2), random.real(-1, 1));
    const double offset = random.real(-0.2, 0.2);
    const Vec2 p(random.real(-0.1, 0.1), random.real(-0.5, 0.5)), across(-1, 0);
    const BisectorSample at_p = sample(p, left, offset, right, 0);
    const Vec2 q = p + at_p.distance_to_bisector(across, 1e-14) * across;
    const BisectorSample at_q = sample(q, left, offset, right, 0);
    REQUIRE(std::abs(at_q.error()) < 1e-7);  // four of Newton's steps
    REQUIRE(std::abs(at_q.error()) <= std::abs(at_p.error()) + 1e-15);
    ++found;
  }
  CHECK(found == 1000);
}

TEST_CASE("the rounding bound covers sums of two terms") {
  test::Random random(2);
  for (int round = 0; round < 1000; ++round) {
    const Vec2 p(random.real(-1, 1), random.real(-1, 1)), image(random.real(2, 9), random.real(-1, 1));
    // The same distance, its offset added in two ways.
    const double offset = random.real(0, 5);
    const double far = (p - image).norm();
    const BisectorSample s{p, {nullptr, {offset + far, image}}, {nullptr, {(offset + 1) + (far - 1), image}}};
    REQUIRE(std::abs(s.error()) <= 8 * s.rounding());
  }
}

SearchBand band_between(const Vec2& from, const Vec2& to, double width) {
  const Vec2 along = (to - from).normalized();
  return {from, along, turned_left(along), (to - from).norm(), width};
}

bool sees(const FaceSource& s, const Vec2& p) { return s.shortest_path(p).from == s.image; }

TEST_CASE("a band contains its chord, and what is as near as its width, also beyond the ends") {
  const SearchBand band = band_between({1, 1}, {3, 1}, 0.25);
  CHECK(band.contains({1, 1}));
  CHECK(band.contains({3.25, 1.25}));
  CHECK_FALSE(band.contains({3.26, 1}));
  CHECK_FALSE(band.contains({2, 1.26}));
  CHECK(band.position({2.5, 1.1}) == Approx(1.5));
  CHECK_FALSE(band.is_all());
  CHECK(band_between({1, 1}, {3, 1}, kInfinity).is_all());
}

TEST_CASE("without sources nothing is visible, and the nearest path is infinite") {
  std::vector<VisibleSource> visible(3);
  collect_visible_sources({}, band_between({0, 1}, {1, 1}, 0.1), visible);
  CHECK(visible.empty());
  CHECK(std::isinf(nearest_visible(visible, 0, {0, 1}).path.distance));
}

TEST_CASE("corners are visible from everywhere, and every source where the band is the whole plane") {
  const std::vector<FaceSource> sources{test::from_corner(0, 0, {0, 0}, 1),
                                        test::through_side(0, 0, {5, -1}, {{5, 0}, {5.1, 0}}, 0)};
  std::vector<VisibleSource> visible;
  collect_visible_sources(sources, band_between({0, 1}, {1, 1}, 0.01), visible);
  REQUIRE(visible.size() == 1);
  CHECK(visible[0].source == &sources[0]);
  CHECK(visible[0].first == -kInfinity);
  CHECK(visible[0].last == kInfinity);
  collect_visible_sources(sources, band_between({0, 1}, {1, 1}, kInfinity), visible);
  CHECK(visible.size() == 2);
}

TEST_CASE("every source that sees a point of a random band is visible at its position") {
  test::Random random(3);
  int seen = 0, passed_over = 0;
  for (int round = 0; round < 2000; ++round) {
    const double begin = random.real(0, 2), end = begin + random.real(0.01, 1);
    const Vec2 image(random.real(-1, 3), random.real(-2, -0.1));
    const std::vector<FaceSource> sources{test::through_side(0, 0, image, {{begin, 0}, {end, 0}}, 0)};
    const Vec2 from(random.real(0, 2), random.real(0.1, 2)), to(random.real(0, 2), random.real(0.1, 2));
    const SearchBand band = band_between(from, to, 0.05 * (to - from).norm());
    std::vector<VisibleSource> visible;
    collect_visible_sources(sources, band, visible);
    for (int k = 0; k < 30; ++k) {
      const Vec2 p = from + random.real(-0.05, 1.05) * (to - from) + random.real(-1, 1) * band.width * band.across;
      if (!sees(sources[0], p)) {
        passed_over += visible.empty();
        continue;
      }
      ++seen;
      INFO("round " << round);
      REQUIRE(visible.size() == 1);
      REQUIRE(nearest_visible(visible, band.position(p), p).path.distance == sources[0].distance(p));
    }
  }
  CHECK(seen > 1000);
  CHECK(passed_over > 1000);
}

const PlaneSegment kSegment{{0, 0}, {1, 0}};

/// A source that sees all points from its image.
FaceSource seeing_all(const Vec2& image, double offset) {
  return FaceSource::corner(image, offset, GeneratorId(0), HalfedgeId(0));
}

PathChange change_between(const FaceSource& first, const FaceSource& second) {
  return PathChange(kSegment, {&first, first.shortest_path(kSegment.from)},
                    {&second, second.shortest_path(kSegment.to)});
}

TEST_CASE("two sources on the segment's line: the corner is in the middle, and as high as the lines make it") {
  const FaceSource first = seeing_all({-1, 0}, 0), second = seeing_all({2, 0}, 0);
  PathChange change = change_between(first, second);
  // The distance rises from 1 to 1.5 and falls to 1 again.
  CHECK(change.height() == 0.5);
  CHECK(change.find(1e-9) == 0.5);
}

TEST_CASE("no corner without a change, nor where the sources tie at an end") {
  CHECK(PathChange().height() == 0);
  const FaceSource first = seeing_all({-1, 0}, 0), second = seeing_all({2, 0}, 1);  // tie at the end
  CHECK(change_between(first, second).height() == 0);
}

TEST_CASE("the height is that of the corner above the chord where distances are nearly linear") {
  const FaceSource first = seeing_all({-1000, 0}, 0), second = seeing_all({1001, 10}, 0.25);
  PathChange change = change_between(first, second);
  const double t = change.find(1e-12);
  const double corner = first.distance({t, 0}), chord = (1 - t) * first.distance({0, 0}) + t * second.distance({1, 0});
  CHECK(std::abs(change_between(first, second).height() - (corner - chord)) < 1e-4 * (corner - chord));
}

TEST_CASE("near curved distances, both sources are equally far at the position found") {
  test::Random random(1);
  int found = 0;
  for (int round = 0; round < 1000; ++round) {
    const FaceSource first = seeing_all({random.real(-1, 0.3), random.real(0.1, 1)}, random.real(0, 0.2));
    const FaceSource second = seeing_all({random.real(0.7, 2), random.real(-1, -0.1)}, random.real(0, 0.2));
    if (!(first.distance({0, 0}) < second.distance({0, 0}) && second.distance({1, 0}) < first.distance({1, 0})))
      continue;
    const double t = change_between(first, second).find(1e-10);
    const Vec2 p(t, 0);
    REQUIRE((t > 0 && t < 1));
    REQUIRE(std::abs(first.distance(p) - second.distance(p)) < 1e-5);  // eight steps
    ++found;
  }
  CHECK(found > 500);
}

}  // namespace gvd::test_refine_arcs
