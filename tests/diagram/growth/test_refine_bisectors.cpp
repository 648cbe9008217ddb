// Refinement by unfolding; test_weld_crossings.cpp has the weld.
#include <cmath>

#include "diagram/growth/refine_bisectors.hpp"
#include "diagram/growth/weld_crossings.hpp"
#include "geodesic/face_layout.hpp"
#include "geodesic/marching/unfold.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/random.hpp"
#include "support/same_crossings.hpp"
#include "support/stages.hpp"

namespace gvd::test_refine_bisectors {

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

}  // namespace gvd::test_refine_bisectors
