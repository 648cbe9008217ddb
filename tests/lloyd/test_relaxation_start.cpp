// From options to the start of a relaxation: which generators, and which copy.
#include <string>
#include <vector>

#include "copy_points.hpp"
#include "gvd/relaxation_start.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_relaxation_start {

RelaxationStartOptions sampled(std::int32_t count) {
  RelaxationStartOptions options;
  options.sampling.count = count;
  return options;
}

TEST_CASE("start_relaxation: sampled generators are those of sample_generators, and those of the copy with one") {
  const Mesh mesh = test::make_torus(80, 40);
  RelaxationStartOptions options = sampled(30);
  const RelaxationStart plain = start_relaxation(mesh, options);
  CHECK(plain.points == sample_generators(mesh, options.sampling));
  CHECK(!plain.copy);
  options.copy.faces = 1000;
  const RelaxationStart coarse = start_relaxation(mesh, options);
  REQUIRE(coarse.copy);
  CHECK(coarse.points == value_or_throw(sample_on_copy(mesh, *coarse.copy, options.sampling)));
  options.sampling.kind = Sampling::random;
  CHECK(start_relaxation(mesh, options).points == sample_generators(mesh, options.sampling));
}

TEST_CASE("start_relaxation: a copy has room for the generators, and half of the faces at most") {
  const Mesh mesh = test::make_torus(80, 40);  // 6400 faces
  RelaxationStartOptions options = sampled(30);
  for (const auto& [faces, used] : {std::pair(59, false), {60, true}, {3200, true}, {3201, false}, {0, false}}) {
    CAPTURE(faces);
    options.copy.faces = faces;
    CHECK(start_relaxation(mesh, options).copy.has_value() == used);
  }
  options.copy.faces.reset();
  options.copy.above = mesh.face_count() - 1;
  options.copy.size.least = 1000;
  CHECK(start_relaxation(mesh, options).copy);
  options.copy.above = mesh.face_count();
  CHECK(!start_relaxation(mesh, options).copy);
}

TEST_CASE("start_relaxation: listed generators stay, and have a copy only where it is asked for") {
  const Mesh mesh = test::make_torus(80, 40);
  RelaxationStartOptions options;
  options.listed = {vertex_point(mesh, VertexId(5)), vertex_point(mesh, VertexId(700))};
  options.copy.above = 0;
  options.copy.size.least = 1000;
  const RelaxationStart start = start_relaxation(mesh, options);
  CHECK(start.points == options.listed);
  CHECK(!start.copy);
  options.copy.faces = 500;
  CHECK(start_relaxation(mesh, options).copy);
  options.copy.faces.reset();
  options.listed.clear();
  options.sampling.kind = Sampling::covering_radius;
  options.sampling.radius = 1;
  CHECK(!start_relaxation(mesh, options).copy);
}

TEST_CASE("copy_options: no copy without iterations, and none by default for methods that are compared") {
  LloydOptions relaxation;
  CopyOptions asked;
  CHECK(!copy_options(relaxation, asked).faces);
  relaxation.acceleration = Acceleration::none;
  CHECK(copy_options(relaxation, asked).faces == 0);
  asked.faces = 500;
  CHECK(copy_options(relaxation, asked).faces == 500);
  relaxation.max_iterations = 0;
  CHECK(copy_options(relaxation, asked).faces == 0);
}

TEST_CASE("start_relaxation: steps are told in their order, and constraints and weights reach the relaxation") {
  const Mesh mesh = test::make_torus(80, 40);
  RelaxationStartOptions options = sampled(30);
  options.copy.faces = 1000;
  options.weighs_curvature = true;
  options.constraints.fixed = {vertex_point(mesh, VertexId(5))};
  std::vector<std::string> steps;
  options.on_step = [&](std::string_view step) { steps.emplace_back(step); };
  const RelaxationStart start = start_relaxation(mesh, options);
  CHECK(steps == std::vector<std::string>{"coarse copy", "generators", "density", "constraints"});
  CHECK(!start.density.is_uniform());
  REQUIRE(start.freedom.size() == 30);
  CHECK(start.freedom[0] == Freedom::fixed);
  LloydOptions relaxation;
  relaxation.max_iterations = 3;
  const LloydResult result = relax_generators(mesh, start, relaxation);
  CHECK(result.copy.faces == start.copy->mesh.face_count());
  CHECK(result.generators[0] == options.constraints.fixed[0]);
}

}  // namespace gvd::test_relaxation_start
