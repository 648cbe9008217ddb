// Where the rounds of a repair end at a limit: how many more generators it would take, and what the error advises.
#include <cmath>
#include <string>

#include "base/least.hpp"
#include "gvd/check.hpp"
#include "gvd/remesh.hpp"
#include "remesh/remesh_refusal.hpp"
#include "repair/added_generators.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_repair_limits {

TEST_CASE("remesh: a refusal estimates how many generators are needed") {
  const Mesh loose = test::make_loose_triangles(40);
  const std::vector<SurfacePoint> first{vertex_point(loose, VertexId(0))};
  RemeshOptions few, enough;
  few.max_added = 20;
  enough.max_added = 200;
  const std::int64_t needed = remesh(loose, first, enough).added;
  CHECK(needed >= 119);  // three for each
  CHECK(needed <= 125);
  CHECK_THAT(
      test::remesh_refusal(loose, first, few).what(),
      Catch::Matchers::Contains("20 generators were added") &&
          Catch::Matchers::Contains("about 119 are likely to be needed: give more or other ones, or raise max_added"));
}

/// The mesh's vertices nearest to planes of constant x, evenly apart.
std::vector<SurfacePoint> points_along_x(const Mesh& mesh, double half_length, int count) {
  std::vector<SurfacePoint> points;
  for (int k = 0; k < count; ++k) {
    const double x = half_length * ((2.0 * k + 1) / count - 1);
    Least<VertexId> nearest;
    for (const VertexId v : mesh.vertices()) nearest.offer(std::abs(mesh.position(v).x() - x), v);
    points.push_back(vertex_point(mesh, nearest.value));
  }
  return points;
}

TEST_CASE("remesh: the default limit is raised where that is likely to do, a given one is not") {
  const Mesh needle = test::stretched(test::make_sphere(3), {150, 1, 1});
  const auto given = points_along_x(needle, 150, 20);
  RemeshOptions options;
  options.placement.method = Placement::generator;
  const std::int64_t usual = default_max_added(compute_mesh_summary(needle), given.size());
  const RemeshResult result = remesh(needle, given, options);
  CHECK(result.added > usual);
  CHECK(result.max_added == 3 * usual);
  options.max_added = usual;
  CHECK_THAT(test::remesh_refusal(needle, given, options).what(), Catch::Matchers::Contains("raise max_added"));
}

TEST_CASE("remesh: with a limit below the default, a higher one is advised, and helps") {
  using Catch::Matchers::Contains;
  const Mesh needle = test::stretched(test::make_sphere(2), {100, 1, 1});
  std::vector<SurfacePoint> given;
  for (int v = 0; v < 4; ++v) given.push_back(vertex_point(needle, VertexId(v)));
  RemeshOptions options;
  options.placement.method = Placement::generator;
  options.max_added = 10;
  CHECK_THAT(
      test::remesh_refusal(needle, given, options).what(),
      Contains("10 generators were added in 5 rounds, and 5 defects became 17; by default, 150 may be added: give "
               "more or other ones, or raise max_added"));
  options.max_added = 100;
  CHECK_THAT(test::remesh_refusal(needle, given, options).what(),
             Contains("are likely to be needed: give more or other ones, or raise max_added") && !Contains("worse"));
  options.max_added = 200;
  CHECK(remesh(needle, given, options).added < 200);
}

TEST_CASE("remesh: the estimate of needed generators follows the defects") {
  MeshSummary sphere;
  sphere.components = 1;
  CHECK(estimate_added(sphere, 50, {{0, 100}, {10, 80}, {20, 60}}) == 50);
  CHECK(estimate_added(sphere, 50, {{0, 100}, {20, 100}}) == std::nullopt);
  CHECK(estimate_added(sphere, 50, {{0, 100}, {20, 130}}) == std::nullopt);
  CHECK(estimate_added(sphere, 50, {{0, 10}, {20, 100}, {40, 60}}) == 70);  // from the most defects on
  CHECK(estimate_added(sphere, 2, {{1, 3}}) == 3);                          // four vertices
  sphere.components = sphere.boundary_loops = 30;
  CHECK(estimate_added(sphere, 10, {{0, 30}, {9, 21}}) == 89);
}

TEST_CASE("remesh: at a limit, more generators are advised unless many of them made it worse") {
  using Catch::Matchers::EndsWith;
  MeshSummary sphere;
  sphere.components = 1;
  sphere.euler_characteristic = 2;
  const auto advice = [&](const RepairHistory& history, bool is_max_added, std::size_t generators = 50) {
    const std::int64_t usual = default_max_added(sphere, generators - std::size_t(history.back().first));
    return advise_at_limit(sphere, generators, history, is_max_added, usual);
  };
  const std::string shrink = ", and 100 defects became 60; about 50 are likely to be needed: give more or other ones";
  CHECK(advice({{0, 100}, {10, 80}, {20, 60}}, true) == shrink + ", or raise \1max_added\2");
  CHECK(advice({{0, 100}, {10, 80}, {20, 60}}, false) == shrink);  // the limit of rounds
  CHECK(advice({{0, 10}, {20, 100}, {40, 60}}, true) ==
        ", and 10 defects became 100, then 60; about 70 are likely to be needed: give more or other ones, or raise "
        "\1max_added\2");
  // As many as the default allows: ten for each given generator and component, and 100 more.
  const std::string grow =
      ", and 100 defects became 150; so far, added generators make it worse, so look at the surface there: it may be "
      "thin, folded or far too coarse";
  CHECK(advice({{0, 100}, {210, 150}}, true, 220) == grow);
  CHECK(advice({{0, 100}, {20, 150}}, false) == grow);  // the limit of rounds
  CHECK(advice({{0, 100}, {209, 150}}, true, 219) ==
        ", and 100 defects became 150; by default, 210 may be added: give more or other ones, or raise "
        "\1max_added\2");
  // As many, but not more defects than chance may make.
  CHECK(advice({{0, 100}, {210, 128}}, true, 220) ==
        ", and 100 defects became 128: give more or other ones, or raise \1max_added\2");
  CHECK(advice({{0, 100}, {20, 100}}, false) == ", and 100 defects became 100: give more or other ones");
  CHECK(advice({{0, 5}}, true) ==  // none may be added
        "; by default, 610 may be added: give more or other ones, or raise \1max_added\2");
  // Defects that grow while the topology needs more generators: two for three vertices are too few.
  CHECK_THAT(advice({{0, 1}, {1, 3}}, true, 2),
             EndsWith("became 3; about 3 are likely to be needed: give more or other ones, or raise \1max_added\2"));
}

}  // namespace gvd::test_repair_limits
