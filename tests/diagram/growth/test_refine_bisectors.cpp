// Refinement by unfolding, and the weld of the estimates.
#include <cmath>
#include <vector>

#include "diagram/graph/face_diagram.hpp"
#include "diagram/growth/refine_bisectors.hpp"
#include "geodesic/face_layout.hpp"
#include "geodesic/marching/unfold.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/random.hpp"
#include "support/same_crossings.hpp"
#include "support/stages.hpp"

namespace gvd::test_refine_bisectors {

using test::require_same_order;

TEST_CASE("a face is laid out with its own lengths, counter-clockwise, and points come back") {
  const Mesh mesh = test::make_thin_faced_sphere(2, 3);
  for (int f = 0; f < mesh.face_count(); ++f) {
    const FaceLayout layout(mesh, FaceId(f));
    const auto& corner = layout.corner;
    for (std::size_t i = 0; i < 3; ++i) {
      const double length = mesh.length(Mesh::halfedge(FaceId(f), static_cast<int>(i)));
      REQUIRE((corner[(i + 1) % 3] - corner[i]).norm() == Approx(length).epsilon(1e-6));
    }
    REQUIRE(corner[2].y() > 0);
    const std::array<double, 3> inside{0.2, 0.5, 0.3};
    const auto back = layout.bary(layout.at(inside));
    for (std::size_t i = 0; i < 3; ++i) REQUIRE(back[i] == Approx(inside[i]).margin(1e-9));
  }
}

TEST_CASE("a source unfolds to where it is, on the right of the edge") {
  test::Random random(21);
  for (int i = 0; i < 2000; ++i) {
    const Vec2 a(random.real(-2, 2), random.real(-2, 2)), b(random.real(-2, 2), random.real(-2, 2));
    const Vec2 along = b - a, right(along.y(), -along.x());
    const Vec2 source = a + random.real(-1, 2) * along + random.real(0.1, 2) * right;
    if (along.norm() < 0.1) continue;
    REQUIRE((unfold_source(a, b, (source - a).norm(), (source - b).norm()) - source).norm() < 1e-9);
  }
  // Distances that no triangle has: on the line.
  CHECK(std::abs(unfold_source({0, 0}, {1, 0}, 0.2, 0.2).y()) == 0);
}

TEST_CASE("estimates lie inside their edge, ascending by face, on every family") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    const test::Stages stages(mesh, test::random_generators(mesh, 20, 8), Front::planar);
    const auto estimates = refine_bisectors(stages.input(), stages.rough);
    std::vector<int> count(stages.rough.size(), 0);
    for (const CrossingEstimate& e : estimates) {
      REQUIRE((e.t > 0 && e.t < 1));
      REQUIRE(++count[e.crossing.index()] <= 2);
    }
    Crossings welded = stages.rough;
    weld_crossings(estimates, welded);
    test::require_same_order(stages.rough, welded);
  }
}

const GeneratorId kA(0), kB(1), kC(2);

/// Three crossings on edge 0 and one on edge 2.
Crossings sample_crossings() {
  return Crossings(
      3, {{EdgeId(0), 0.2, kA, kB}, {EdgeId(0), 0.5, kB, kC}, {EdgeId(0), 0.8, kC, kA}, {EdgeId(2), 0.4, kA, kB}});
}

CrossingEstimate estimate(int crossing, double t) { return {CrossingId(crossing), t}; }

TEST_CASE("the weld takes the mean, and keeps a crossing without an estimate") {
  Crossings crossings = sample_crossings();
  weld_crossings({estimate(1, 0.4), estimate(3, 0.7), estimate(1, 0.46)}, crossings);
  CHECK(crossings.items()[0].t == 0.2);
  CHECK(crossings.items()[1].t == Approx(0.43));
  CHECK(crossings.items()[2].t == 0.8);
  CHECK(crossings.items()[3].t == 0.7);
}

TEST_CASE("the weld keeps the order and the least distances for any estimates") {
  Crossings crossings = sample_crossings();
  weld_crossings({estimate(0, 0.95), estimate(1, 0.01), estimate(2, 0.99999999), estimate(3, 1e-12)}, crossings);
  require_same_order(sample_crossings(), crossings);
  CHECK(crossings.items()[0].t == Approx(0.5 - kCrossingGap));
  CHECK(crossings.items()[2].t == Approx(1 - kCrossingGap));
  CHECK(crossings.items()[3].t == Approx(kCrossingGap));
  test::Random random(22);
  for (int i = 0; i < 2000; ++i) {
    Crossings fuzzed = sample_crossings();
    std::vector<CrossingEstimate> estimates;
    for (int k = random.below(9); k > 0; --k) estimates.push_back(estimate(random.below(4), random.real(0, 1)));
    weld_crossings(estimates, fuzzed);
    require_same_order(sample_crossings(), fuzzed);
  }
}

TEST_CASE("two crossings at their least distance stay") {
  const Crossings before(1, {{EdgeId(0), 0.5, kA, kB}, {EdgeId(0), 0.5 + kCrossingGap, kB, kC}});
  Crossings after = before;
  weld_crossings({estimate(0, 0.9), estimate(1, 0.1)}, after);
  CHECK(after.items()[0].t == Approx(0.5).margin(1e-12));
  CHECK(after.items()[1].t - after.items()[0].t >= kCrossingGap * (1 - 1e-6));
}

}  // namespace gvd::test_refine_bisectors
