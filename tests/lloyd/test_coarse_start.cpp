// Relaxations that begin on a decimated copy of the mesh.
#include <algorithm>
#include <cmath>
#include <utility>

#include "copy_points.hpp"
#include "gvd/constrained_start.hpp"
#include "gvd/diagram.hpp"
#include "gvd/lloyd.hpp"
#include "gvd/sampling.hpp"
#include "support/cancelled.hpp"
#include "support/catch.hpp"
#include "support/featured_meshes.hpp"
#include "support/meshes.hpp"
#include "support/sanitized.hpp"

namespace gvd::test_coarse_start {

std::vector<SurfacePoint> sample(const Mesh& mesh, int count, std::uint64_t seed = 0) {
  SamplingOptions options;
  options.count = count;
  options.seed = seed;
  return sample_generators(mesh, options);
}

LloydResult relax_on_copy(const Mesh& mesh, const std::vector<SurfacePoint>& generators, const CoarseCopy& copy,
                          const LloydOptions& options = {}) {
  return relax_generators(mesh, generators, options, {.copy = &copy});
}

TEST_CASE("relax_generators: from a copy, the energy is that of the relaxation on the mesh, for fewer diagrams of it") {
  for (const auto& [name, mesh] : {test::NamedMesh{"bumpy sphere", test::make_bumpy_sphere(5, 3)},
                                   test::NamedMesh{"torus", test::make_torus(160, 60)}}) {
    const CoarseCopy copy = make_coarse_copy(mesh, 4000);
    for (const std::uint64_t seed : test::thinned({0, 1})) {
      CAPTURE(name, seed);
      const auto start = sample(mesh, 60, seed);
      const LloydResult plain = relax_generators(mesh, start), result = relax_on_copy(mesh, start, copy);
      // Starts that differ a little end in other minima, up to half a percent apart: on the average they are equal.
      CHECK(result.final_energy < 1.005 * plain.final_energy);
      CHECK(result.diagrams < plain.diagrams / 3);
      CHECK(result.copy.faces == copy.mesh.face_count());
      CHECK(result.copy.iterations > 5);
      CHECK(result.iterations.size() <= std::size_t(kFinishIterations));
      CHECK(result.generators == result.diagram.generators);
    }
  }
}

TEST_CASE("relax_generators: the energy on a copy's generators is near that of many more iterations on the mesh") {
  const Mesh mesh = test::make_bumpy_sphere(5, 3);
  const CoarseCopy copy = make_coarse_copy(mesh, 4000);
  const LloydResult result = relax_on_copy(mesh, sample(mesh, 60), copy);
  const LloydResult further = relax_generators(mesh, result.generators);
  CHECK(further.final_energy <= result.final_energy);
  CHECK(further.final_energy > 0.998 * result.final_energy);
}

TEST_CASE("relax_generators: with a tolerance, a relaxation from a copy goes on until it holds on the mesh") {
  const Mesh mesh = test::make_bumpy_sphere(4, 3);
  const CoarseCopy copy = make_coarse_copy(mesh, 800);
  LloydOptions options;
  options.energy_tolerance = 1e-8;
  const LloydResult result = relax_on_copy(mesh, sample(mesh, 30), copy, options);
  CHECK(result.iterations.size() > std::size_t(kFinishIterations));
  CHECK((result.stop == LloydStop::centroids || result.stop == LloydStop::energy));
  CHECK(result.residual < 0.01 * result.mean_cell_radius);
}

TEST_CASE("relax_generators: iterations on a copy count, so that fewer of them cost less, and more lower the energy") {
  const Mesh mesh = test::make_bumpy_sphere(5, 3);
  const CoarseCopy copy = make_coarse_copy(mesh, 4000);
  const auto start = sample(mesh, 60);
  double before = kInfinity;
  for (const std::int32_t most : {0, 1, 2, 4, 8}) {
    CAPTURE(most);
    LloydOptions options;
    options.max_iterations = most;
    const LloydResult result = relax_on_copy(mesh, start, copy, options);
    CHECK(result.copy.iterations + std::ssize(result.iterations) <= most);
    CHECK(result.diagrams == 1);  // those of the copy take a tenth of the time
    CHECK(result.final_energy < before);
    before = result.final_energy;
  }
}

TEST_CASE("relax_generators: from a copy, the same on any number of threads") {
  const Mesh mesh = test::make_torus(160, 60);
  LloydResult results[2];
  for (const int threads : {1, 2}) {
    const CoarseCopy copy = make_coarse_copy(mesh, 4000, threads);
    LloydOptions options;
    options.diagram.threads = threads;
    options.max_iterations = 8;
    const auto start = value_or_throw(sample_on_copy(mesh, copy, {.count = 50, .progress = {}}));
    results[threads - 1] = relax_generators(mesh, start, options, {.copy = &copy, .keeps_extremities = true});
  }
  CHECK(results[0].generators == results[1].generators);
  CHECK(results[0].final_energy == results[1].final_energy);
  CHECK(results[0].copy.iterations == results[1].copy.iterations);
}

TEST_CASE("relax_generators: from a copy, generators keep to their component, and are apart") {
  const Mesh mesh = test::make_nested_spheres(0.97);
  const CoarseCopy copy = make_coarse_copy(mesh, mesh.face_count() / 3);
  const auto component = compute_face_components(mesh);
  const auto start = sample(mesh, 30);
  const LloydResult result = relax_on_copy(mesh, start, copy);
  REQUIRE(result.copy.faces > 0);
  CHECK(are_apart(mesh, result.generators));
  for (std::size_t i = 0; i < start.size(); ++i) {
    CHECK(component[result.generators[i].face] == component[start[i].face]);
  }
}

TEST_CASE("relax_generators: from a copy, fixed generators stay, and those on the boundary keep to it") {
  const Mesh mesh = test::make_half_sphere(5);
  StartOptions asked;
  asked.keep_boundary = true;
  asked.fixed = {make_surface_point(FaceId(100), {0.2, 0.3, 0.5}), vertex_point(mesh, VertexId(500))};
  const ConstrainedStart start = value_or_throw(constrain_start(mesh, sample(mesh, 50), asked));
  const CoarseCopy copy = make_coarse_copy(mesh, mesh.face_count() / 5);
  LloydOptions options;
  options.freedom = start.freedom;
  options.creases = start.creases;
  const LloydResult result = relax_on_copy(mesh, start.points, copy, options);
  REQUIRE(result.copy.faces > 0);
  CHECK(result.copy.iterations > 0);
  int moved = 0;
  for (std::size_t i = 0; i < start.points.size(); ++i) {
    if (start.freedom[i] == Freedom::fixed) CHECK(result.generators[i] == start.points[i]);
    if (start.freedom[i] == Freedom::on_crease) CHECK(is_on_boundary(mesh, result.generators[i]));
    if (start.freedom[i] == Freedom::free) moved += result.generators[i] != start.points[i];
  }
  CHECK(moved > 20);
}

TEST_CASE("relax_generators: from a copy, extremities keep their generators") {
  const Mesh mesh = test::make_spindle();
  const CoarseCopy copy = make_coarse_copy(mesh, mesh.face_count() / 3);
  LloydOptions options;
  options.max_iterations = 15;
  const LloydStages stages{.copy = &copy, .keeps_extremities = true};
  const LloydResult result = relax_generators(mesh, sample(mesh, 60), options, stages);
  CHECK(result.extremities.size() == 2);
  for (const GeneratorId g : result.extremities) {
    const Vec3 at = position(mesh, result.generators[g.index()]);
    CHECK(std::min((at - mesh.position(VertexId(0))).norm(),
                   (at - mesh.position(VertexId(mesh.vertex_count() - 1))).norm()) < 3 * mesh.mean_edge_length());
  }
}

TEST_CASE("relax_generators: the density counts on the copy, too") {
  const Mesh mesh = test::make_grid(60, 60);
  std::vector<double> heavy;
  for (const Vec3& p : mesh.positions()) heavy.push_back(p.x() < 30 ? 1 : 16);
  LloydOptions options;
  options.density = make_vertex_density(mesh, heavy);
  const auto start = sample(mesh, 60);
  const CoarseCopy copy = make_coarse_copy(mesh, 1500);
  const LloydResult plain = relax_generators(mesh, start, options);
  const LloydResult result = relax_on_copy(mesh, start, copy, options);
  REQUIRE(result.copy.faces > 0);
  CHECK(result.final_energy < 1.01 * plain.final_energy);
  const auto on_right =
      std::ranges::count_if(result.generators, [&](const SurfacePoint& p) { return position(mesh, p).x() > 30; });
  CHECK(on_right > 36);  // sizes go with density^(-1/4): two thirds
}

TEST_CASE("relax_generators: a copy that is large, or on which generators coincide, is not used") {
  const Mesh mesh = test::make_sphere(4);
  const auto start = sample(mesh, 20);
  LloydOptions options;
  options.max_iterations = 3;
  const LloydResult plain = relax_generators(mesh, start, options);
  const CoarseCopy large = make_coarse_copy(mesh, mesh.face_count() * 3 / 4);
  const LloydResult unused = relax_on_copy(mesh, start, large, options);
  CHECK(unused.copy.faces == 0);
  CHECK(unused.generators == plain.generators);
  CHECK(unused.final_energy == plain.final_energy);
  // Seen from far away, most points have a vertex of the copy for their closest point.
  CoarseCopy shrunk = make_coarse_copy(mesh, 60);
  std::vector<Vec3> positions = shrunk.mesh.positions();
  for (Vec3& p : positions) p *= 1e-3;
  shrunk.mesh = Mesh(std::move(positions), shrunk.mesh.face_vertices());
  std::vector<SurfacePoint> all;
  for (const VertexId v : mesh.vertices()) all.push_back(vertex_point(mesh, v));
  options.max_iterations = 1;
  const LloydResult crowded = relax_on_copy(mesh, all, shrunk, options);
  CHECK(crowded.copy.faces == 0);
  CHECK(crowded.generators.size() == all.size());
}

/// The energy of generators on a mesh.
double energy_of(const Mesh& mesh, const std::vector<SurfacePoint>& generators) {
  LloydOptions options;
  options.max_iterations = 0;
  return relax_generators(mesh, generators, options).final_energy;
}

TEST_CASE("relax_generators: a relaxation that ends on a copy computes one diagram of the mesh") {
  for (const auto& [name, mesh] : {test::NamedMesh{"bumpy sphere", test::make_bumpy_sphere(5, 3)},
                                   test::NamedMesh{"torus", test::make_torus(160, 60)}}) {
    const CoarseCopy copy = make_coarse_copy(mesh, 2000);
    const auto start = sample(mesh, 60);
    LloydOptions options;
    options.max_iterations = 15;
    const LloydResult result = relax_generators(mesh, start, options, {.copy = &copy, .ends_on_copy = true});
    const LloydResult plain = relax_generators(mesh, start, options, {.ends_on_copy = true});
    CAPTURE(name);
    CHECK(plain.copy.faces == 0);
    CHECK(plain.diagrams > 10);
    CHECK(result.diagrams == 1);
    CHECK(result.copy.faces == copy.mesh.face_count());
    CHECK(result.copy.iterations == std::ssize(result.iterations));
    CHECK(result.iterations.back().is_sampled);
    CHECK(energy_of(mesh, result.generators) < 1.01 * plain.final_energy);
    const Diagram diagram = compute_diagram(mesh, result.generators);
    CHECK(result.diagram.generators == result.generators);
    CHECK(result.diagram.vertex_label == diagram.vertex_label);
    CHECK(result.diagram.vertex_distance == diagram.vertex_distance);
  }
}

TEST_CASE(
    "relax_generators: a relaxation that ends on a copy finds extremities on the mesh, on any number of threads") {
  const Mesh mesh = test::make_spindle();
  LloydResult results[2];
  for (const int threads : {1, 2}) {
    const CoarseCopy copy = make_coarse_copy(mesh, mesh.face_count() / 3, threads);
    LloydOptions options;
    options.max_iterations = 15;
    options.diagram.threads = threads;
    const LloydStages stages{.copy = &copy, .ends_on_copy = true, .keeps_extremities = true};
    results[threads - 1] = relax_generators(mesh, sample(mesh, 60), options, stages);
  }
  const LloydResult& result = results[0];
  CHECK(result.generators == results[1].generators);
  CHECK(result.diagram.vertex_distance == results[1].diagram.vertex_distance);
  REQUIRE(result.extremities.size() == 2);
  std::vector<VertexId> ends;
  for (const GeneratorId g : result.extremities) {
    REQUIRE(result.generators[g.index()].kind() == SurfacePoint::Kind::vertex);
    ends.push_back(vertex(mesh, result.generators[g.index()]));
  }
  std::sort(ends.begin(), ends.end());
  CHECK(ends == std::vector{VertexId(0), VertexId(mesh.vertex_count() - 1)});
  CHECK(result.diagrams == 2);
  CHECK(result.copy.iterations == std::ssize(result.iterations));
}

TEST_CASE("relax_generators: without a copy that can be used, a relaxation ends on the mesh") {
  const Mesh mesh = test::make_spindle();
  const auto start = sample(mesh, 60);
  const CoarseCopy large = make_coarse_copy(mesh, mesh.face_count() * 3 / 4);
  LloydOptions options;
  options.max_iterations = 15;
  const LloydStages stages{.copy = &large, .ends_on_copy = true, .keeps_extremities = true};
  const LloydResult unused = relax_generators(mesh, start, options, stages);
  const LloydResult plain = relax_generators(mesh, start, options, {.keeps_extremities = true});
  CHECK(unused.copy.faces == 0);
  CHECK(unused.generators == plain.generators);
  CHECK(unused.final_energy == plain.final_energy);
  CHECK(unused.extremities == plain.extremities);
}

TEST_CASE("relax_generators: an interrupt on the copy or on the mesh throws") {
  const Mesh mesh = test::make_sphere(3);
  const CoarseCopy copy = make_coarse_copy(mesh, 300);
  const auto start = sample(mesh, 10);
  test::require_cancelled_everywhere([&](const Progress& progress) {
    LloydOptions options;
    options.max_iterations = 3;
    options.diagram.threads = 1;
    options.progress = progress;
    relax_on_copy(mesh, start, copy, options);
    relax_generators(mesh, start, options, {.copy = &copy, .ends_on_copy = true, .keeps_extremities = true});
  });
}

}  // namespace gvd::test_coarse_start
