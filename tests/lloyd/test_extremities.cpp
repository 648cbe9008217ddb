// The ends of limbs: a relaxation to centroids leaves them, and keeps_extremities puts generators there.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "gvd/lloyd.hpp"
#include "gvd/sampling.hpp"
#include "support/catch.hpp"
#include "support/featured_meshes.hpp"
#include "support/meshes.hpp"
#include "support/sanitized.hpp"

namespace gvd::test_extremities {

/// Euclidean distance from the nearest generator to the end of a limb that has the farther one, in radii of even cells.
double farthest_end(const Mesh& mesh, const std::vector<SurfacePoint>& generators) {
  double farthest = 0;
  for (const VertexId end : {VertexId(0), VertexId(mesh.vertex_count() - 1)}) {
    double nearest = 1e300;
    for (const SurfacePoint& g : generators) {
      nearest = std::min(nearest, (position(mesh, g) - mesh.position(end)).norm());
    }
    farthest = std::max(farthest, nearest);
  }
  return farthest / std::sqrt(compute_area(mesh) / (std::numbers::pi * double(generators.size())));
}

std::vector<SurfacePoint> sample(const Mesh& mesh, int count, std::uint64_t seed = 0) {
  SamplingOptions options;
  options.count = count;
  options.seed = seed;
  return sample_generators(mesh, options);
}

LloydResult relax(const Mesh& mesh, const std::vector<SurfacePoint>& start, bool keeps_extremities,
                  LloydOptions options = {}) {
  options.max_iterations = 15;
  return relax_generators(mesh, start, options, {.keeps_extremities = keeps_extremities});
}

TEST_CASE("extremities: the ends of limbs keep a generator, which centroids pull off") {
  const Mesh mesh = test::make_spindle();
  for (const int count : {60, 120}) {
    for (const std::uint64_t seed : test::thinned({0, 1, 2})) {
      CAPTURE(count, seed);
      const auto start = sample(mesh, count, seed);
      const LloydResult pulled = relax(mesh, start, false);
      CHECK(farthest_end(mesh, pulled.generators) > 0.5);
      CHECK(pulled.extremities.empty());
      const LloydResult kept = relax(mesh, start, true);
      CHECK(farthest_end(mesh, kept.generators) == 0);
      CHECK(kept.extremities.size() == 2);
      CHECK(kept.generators == kept.diagram.generators);
      CHECK(std::ssize(kept.generators) == count);
      CHECK(kept.iterations.size() > pulled.iterations.size());
    }
  }
}

TEST_CASE("extremities: where no limb ends, nothing changes") {
  for (const Mesh& mesh : {test::make_sphere(3), test::make_torus(24, 12), test::make_grid(9, 7)}) {
    const auto start = sample(mesh, 20);
    const LloydResult plain = relax(mesh, start, false);
    const LloydResult kept = relax(mesh, start, true);
    CHECK(kept.generators == plain.generators);
    CHECK(kept.final_energy == plain.final_energy);
    CHECK(kept.extremities.empty());
  }
}

TEST_CASE("extremities: a generator that may not move stays") {
  const Mesh mesh = test::make_spindle();
  const auto start = sample(mesh, 60);
  LloydOptions options;
  options.freedom.assign(60, Freedom::fixed);
  const LloydResult kept = relax(mesh, start, true, options);
  CHECK(kept.generators == start);
  CHECK(kept.extremities.empty());
}

}  // namespace gvd::test_extremities
