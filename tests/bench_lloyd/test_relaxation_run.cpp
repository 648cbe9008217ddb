#include <cmath>

#include "gvd/lloyd.hpp"
#include "gvd/mesh.hpp"
#include "gvd/sampling.hpp"
#include "relaxation_run.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_relaxation_run {

using namespace bench;

const Mesh& sphere() {
  static const Mesh mesh = test::make_bumpy_sphere(3, 2);
  return mesh;
}
std::vector<SurfacePoint> start() {
  SamplingOptions options;
  options.kind = Sampling::random;
  options.count = 12;
  return sample_generators(sphere(), options);
}

TEST_CASE("E of a diagram does not depend on the size of the mesh, and is that of its relaxation") {
  LloydOptions options;
  options.max_iterations = 3;
  const RelaxationRun run = run_relaxation(sphere(), start(), options);
  CHECK(run.energy == Approx(run.trace.back().energy).epsilon(1e-6));
  CHECK(run.energy > 0.155);
  CHECK(run.energy < 0.25);
  std::vector<Vec3> positions = sphere().positions();
  for (Vec3& p : positions) p *= 10;
  std::vector<std::array<VertexId, 3>> faces;
  for (int f = 0; f < sphere().face_count(); ++f) faces.push_back(sphere().vertices(FaceId(f)));
  const Mesh large(std::move(positions), std::move(faces));
  const Diagram diagram = compute_diagram(large, run.result.generators);
  CHECK(scaled_energy(large, diagram) == Approx(run.energy).epsilon(1e-6));
}

TEST_CASE("a run is traced from its start to its end, in ascending time") {
  LloydOptions options;
  options.max_iterations = 4;
  const RelaxationRun run = run_relaxation(sphere(), start(), options);
  REQUIRE(run.trace.size() >= 5);
  CHECK(run.trace.front().iteration == 0);
  CHECK(run.trace.back().iteration == 4);
  for (std::size_t i = 1; i < run.trace.size(); ++i) {
    CHECK(run.trace[i - 1].seconds <= run.trace[i].seconds);
    CHECK(run.trace[i - 1].iteration <= run.trace[i].iteration);
  }
  CHECK(run.trace.back().seconds <= run.seconds);
}

TEST_CASE("the shortest run to an energy is the first whose result has it") {
  LloydOptions options;
  options.max_iterations = 8;
  const RelaxationRun run = run_relaxation(sphere(), start(), options);
  const double between = 0.5 * (run.trace.front().energy + run.energy);
  const auto shortest = shortest_run_to(between, sphere(), start(), run.trace, 1);
  REQUIRE(shortest);
  CHECK(shortest->energy <= between);
  CHECK(shortest->seconds > 0);
  REQUIRE(shortest->iterations > 0);
  options.max_iterations = shortest->iterations - 1;
  CHECK(run_relaxation(sphere(), start(), options).energy > between);
}

TEST_CASE("an energy that no run reaches has no shortest run") {
  LloydOptions options;
  options.max_iterations = 2;
  const RelaxationRun run = run_relaxation(sphere(), start(), options);
  CHECK_FALSE(shortest_run_to(0.1, sphere(), start(), run.trace, 1));
  CHECK_FALSE(shortest_run_to(run.energy - 1e-6, sphere(), start(), run.trace, 1));
}

TEST_CASE("a flat square has the area n x n and one boundary") {
  const Mesh mesh = make_flat_square(5);
  CHECK(mesh.face_count() == 50);
  CHECK(mesh.vertex_count() == 36);
  CHECK(compute_area(mesh) == Approx(25));
}

TEST_CASE("the interior of a square of square cells has the energy of squares, 1 / 6") {
  const int n = 8;
  const Mesh mesh = make_flat_square(n);
  std::vector<SurfacePoint> centres;
  // The middle of each unit square is the middle of the diagonal, which both faces share.
  for (int square = 0; square < n * n; ++square) centres.push_back({FaceId(2 * square), {0.5, 0, 0.5}});
  const Diagram diagram = compute_diagram(mesh, centres);
  const InteriorEnergy all = interior_energy(mesh, n, diagram, 0);
  CHECK(all.cells == n * n);
  CHECK(all.energy == Approx(1.0 / 6).epsilon(1e-9));
  const InteriorEnergy inner = interior_energy(mesh, n, diagram, 2);
  CHECK(inner.cells == (n - 4) * (n - 4));
  CHECK(inner.energy == Approx(1.0 / 6).epsilon(1e-9));
  CHECK(interior_energy(mesh, n, diagram, n).cells == 0);
}

}  // namespace gvd::test_relaxation_run
