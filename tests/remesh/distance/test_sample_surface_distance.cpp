// Sampled distances are those of their points, in the order of the lattice, and as many as stated.
#include "gvd/closest_point.hpp"
#include "gvd/error.hpp"
#include "gvd/surface_distance.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_sample_surface_distance {

std::size_t lattice_size(const DistanceSamples& samples) {
  std::int64_t size = 0;
  for (const std::int32_t k : samples.steps) size += DistanceSamples::lattice_size(k);
  return static_cast<std::size_t>(size);
}

TEST_CASE("samples at vertices and on lattices are distances of their points") {
  const Mesh coarse = test::make_bumpy_sphere(1, 3), fine = test::make_bumpy_sphere(3, 3);
  const DistanceSamples samples = sample_surface_distance(coarse, fine);
  const ClosestPointTree tree(fine);
  for (std::int32_t i = 0; i < coarse.vertex_count(); ++i) {
    REQUIRE(samples.at_vertex[VertexId(i)] == Approx(tree.query(coarse.position(VertexId(i))).distance).margin(1e-12));
  }
  std::size_t next = 0;
  for (std::int32_t f = 0; f < coarse.face_count(); ++f) {
    const auto& [a, b, c] = coarse.vertices(FaceId(f));
    const std::int32_t k = samples.steps[FaceId(f)];
    REQUIRE(k > 8);
    for (std::int32_t i = 0; i <= k; ++i) {
      for (std::int32_t j = 0; j <= k - i; ++j, ++next) {
        if ((i + j) % 5 != 0) continue;
        const Vec3 point = (i * coarse.position(a) + (k - i - j) * coarse.position(b) + j * coarse.position(c)) / k;
        REQUIRE(samples.lattice[next] == Approx(tree.query(point).distance).margin(1e-12));
      }
    }
  }
  CHECK(next == samples.lattice.size());
}

TEST_CASE("samples are denser in large faces, and bounded in number") {
  // Two faces: one with almost all of the area, one with 1 / 40000 of it.
  const Mesh kite = test::make_mesh({{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, -0.00003, 0}}, {{0, 1, 2}, {0, 3, 1}});
  const DistanceSamples uneven = sample_surface_distance(kite, kite);
  CHECK(uneven.steps[FaceId(0)] == DistanceSamples::kMaxSteps);
  CHECK(uneven.steps[FaceId(1)] == 1);
  CHECK(uneven.lattice.size() == lattice_size(uneven));
  for (const int n : {4, 5, 6}) {
    const Mesh sphere = test::make_sphere(n);
    const DistanceSamples samples = sample_surface_distance(sphere, kite, 2);
    CHECK(samples.lattice.size() == lattice_size(samples));
    CHECK(double(samples.lattice.size()) <= 1.5 * kSampledTriangles);
    CHECK(samples.at_vertex.size() == static_cast<std::size_t>(sphere.vertex_count()));
    if (n == 6) CHECK(samples.lattice.empty());
    if (n == 4) CHECK(samples.lattice == sample_surface_distance(sphere, kite, 1).lattice);
  }
}

TEST_CASE("a mesh without faces has no samples of distances") {
  CHECK_THROWS_AS(sample_surface_distance(Mesh(), test::make_tetrahedron()), Error);
  CHECK_THROWS_AS(sample_surface_distance(test::make_tetrahedron(), Mesh()), Error);
}

}  // namespace gvd::test_sample_surface_distance
