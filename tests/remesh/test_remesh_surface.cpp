// From options to a remesh: start, relaxation, exact numbers, and the search for a distance.
#include <cmath>
#include <string>
#include <vector>

#include "gvd/error.hpp"
#include "gvd/remesh_surface.hpp"
#include "gvd/soup.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_remesh_surface {

SurfaceRemeshOptions sampled(std::int32_t count) {
  SurfaceRemeshOptions options;
  options.start.sampling.count = count;
  return options;
}

TEST_CASE("remesh_surface: sampled generators are relaxed and fitted, listed ones stay where they are") {
  const Mesh mesh = test::make_torus(60, 30);
  const SurfaceRemesh made = remesh_surface(mesh, sampled(60));
  CHECK(made.result.certificate.ok());
  REQUIRE(made.relaxation);
  CHECK(made.relaxation->iterations.size() > 0);
  CHECK(made.options.placement.method == Placement::fit);
  SurfaceRemeshOptions options;
  options.start.listed = made.relaxation->generators;
  const SurfaceRemesh listed = remesh_surface(mesh, options);
  CHECK(!listed.relaxation);
  CHECK(listed.start.points == options.start.listed);
  CHECK(listed.options.placement.method == Placement::generator);
}

TEST_CASE("remesh_surface: creases are followed by default, and not where no generator may be added") {
  const Mesh mesh = test::make_plate(12, 0.5);
  SurfaceRemeshOptions options = sampled(100);
  CHECK(!remesh_surface(mesh, options).start.creases.empty());
  options.remesh.max_added = 0;
  CHECK(remesh_surface(mesh, options).start.creases.empty());
}

TEST_CASE("remesh_surface: an exact number of vertices, though generators are added") {
  const Mesh mesh = test::make_torus(60, 30);
  for (const std::int32_t count : {30, 60}) {
    CAPTURE(count);
    SurfaceRemeshOptions options = sampled(count);
    options.exact_count = true;
    CHECK(remesh_surface(mesh, options).result.mesh.vertex_count() == count);
  }
}

TEST_CASE("remesh_surface: where an exact number fails, the error names one that works") {
  const Mesh mesh = test::make_torus(24, 12);
  SurfaceRemeshOptions options = sampled(4);  // no torus has so few
  options.exact_count = true;
  std::string message;
  try {
    remesh_surface(mesh, options);
  } catch (const Error& error) {
    message = error.what();
  }
  CAPTURE(message);
  CHECK_THAT(message, Catch::Matchers::Contains("no valid mesh of 4 vertices was found"));
  const std::size_t end = message.rfind(" would do");
  REQUIRE(end != message.npos);
  options.start.sampling.count = std::stoi(message.substr(message.rfind(' ', end - 1)));
  CHECK(remesh_surface(mesh, options).result.mesh.vertex_count() == options.start.sampling.count);
}

TEST_CASE("find_remesh_count: the remesh of the number found is within the distance") {
  const Mesh mesh = test::make_torus(60, 30);
  const double distance = 0.02 * mesh.bbox_diagonal();
  SurfaceRemeshOptions options = sampled(1);
  std::vector<CountTrial> trials;
  const Fewest found = find_remesh_count(mesh, options, distance, [&](const CountTrial& t) { trials.push_back(t); });
  REQUIRE(found.count);
  CHECK(trials.size() == found.trials.size());
  options.start.sampling.count = *found.count;
  const RemeshResult result = remesh_surface(mesh, options).result;
  CHECK(std::max(result.input_to_output.hausdorff, result.output_to_input.hausdorff) <= distance);
  CHECK_THROWS_AS(find_remesh_count(test::make_sphere(1), options, 1e-9), Error);
}

TEST_CASE("remesh_surface: a mesh without area is refused, and a cancelled run ends") {
  const Mesh flat = test::make_mesh({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0)}, {{0, 1, 2}});
  CHECK_THROWS_AS(remesh_surface(flat, sampled(1)), Error);
  SurfaceRemeshOptions options = sampled(40);
  options.remesh.diagram.progress = [](std::string_view step, double) { return step != "placement"; };
  CHECK_THROWS_AS(remesh_surface(test::make_torus(60, 30), options), Error);
}

}  // namespace gvd::test_remesh_surface
