// The curvature density does what it is derived for: the remesh is nearer to its surface.
#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "gvd/density.hpp"
#include "gvd/lloyd.hpp"
#include "gvd/remesh.hpp"
#include "gvd/sampling.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/sanitized.hpp"

namespace gvd::test_density_lowers_distance {

/// The larger RMS distance of a remesh that is made as gvd-remesh makes it.
double relaxed_remesh_rms(const Mesh& mesh, std::int32_t count, std::uint64_t seed, Density density) {
  SamplingOptions sampling;
  sampling.count = count;
  sampling.seed = seed;
  LloydOptions options;
  options.max_iterations = 15;
  options.density = std::move(density);
  const LloydResult relaxed = relax_generators(mesh, sample_generators(mesh, sampling), options);
  const RemeshResult result = remesh(mesh, relaxed.generators);
  return std::max(result.input_to_output.rms, result.output_to_input.rms);
}

TEST_CASE("the curvature density lowers the RMS distance of remeshes of a flattened sphere") {
  std::vector<Vec3> positions;
  const Mesh sphere = test::make_sphere(4);
  for (const Vec3& p : sphere.positions()) positions.emplace_back(p.x(), p.y(), p.z() / 4);
  const Mesh mesh(std::move(positions), sphere.face_vertices());
  constexpr std::int32_t kCount = 100;
  for (const std::uint64_t seed : test::thinned({0, 1})) {
    INFO("seed " << seed);
    const double even = relaxed_remesh_rms(mesh, kCount, seed, {});
    // Measured: 0.82 for both. Sizes that are inverse curvatures of edges fail.
    CHECK(relaxed_remesh_rms(mesh, kCount, seed, make_curvature_density(mesh, kCount)) <= 0.95 * even);
  }
}

}  // namespace gvd::test_density_lowers_distance
