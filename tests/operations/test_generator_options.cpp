// Generators by options: sampled as many as asked for, listed ones where they were given.

#include <memory>

#include "gvd/error.hpp"
#include "gvd/generator_options.hpp"
#include "operations/recorder.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_generator_options {

using Catch::Matchers::Contains;
using gvd::test::Recorder;

const CheckedMesh kTorus = as_input(test::make_torus(24, 12));

ResolvedGenerators choose(const GeneratorOptions& options, Recorder& told) {
  return choose_generators(kTorus, options, {}, told);
}

std::vector<SurfacePoint> choose(const GeneratorOptions& options) {
  Recorder told;
  return choose(options, told).points;
}

GeneratorOptions listed(GeneratorEntry entry) {
  GeneratorOptions options;
  options.points.list = std::make_shared<GeneratorList>(GeneratorList{"list", {entry}});
  return options;
}

TEST_CASE("a number of generators gives exactly as many, by every kind of sampling") {
  for (const Sampling kind : {Sampling::farthest, Sampling::random, Sampling::vertices, Sampling::poisson}) {
    GeneratorOptions options;
    options.count = 12;
    options.sampling = kind;
    Recorder told;
    CHECK(choose(options, told).points.size() == 12);
    CHECK(told.steps == std::vector<std::string>{"generators"});
    CHECK(told.details == std::vector<std::string>{"12 generators"});
    CHECK(told.depth == 0);
  }
}

TEST_CASE("a radius gives as many as it takes, and the seed changes a random choice") {
  GeneratorOptions radius;
  radius.radius = 1;
  const std::size_t few = choose(radius).size();
  radius.radius = 0.5;
  CHECK(choose(radius).size() > few);
  GeneratorOptions random;
  random.count = 5;
  random.sampling = Sampling::random;
  const auto first = choose(random);
  CHECK(choose(random) == first);
  random.seed = 1;
  CHECK(choose(random) != first);
}

TEST_CASE("vertices are those of the input, and an error names the option") {
  GeneratorOptions options;
  options.vertices.vertices = {3, 17};
  const auto points = choose(options);
  REQUIRE(points.size() == 2);
  CHECK(vertex(kTorus.mesh, points[1]) == VertexId(17));
  options.vertices.vertices = {3, 3};
  CHECK_THROWS_WITH(choose(options), Contains("vertices: vertex 3 is listed twice; remove one"));
  options.merge_coincident = true;
  CHECK(choose(options).size() == 1);
}

TEST_CASE("a position is snapped, within the distance that is allowed, and a far one is told") {
  GeneratorOptions options = listed({GeneratorEntry::Kind::position, 0, {0, 0, 5}, 1});
  Recorder told;
  const double distance = choose(options, told).snap_distance[0].value();
  CHECK(distance > 1);
  REQUIRE(told.notes.size() == 2);
  CHECK_THAT(told.notes[0], Contains("check its units"));
  CHECK_THAT(told.notes[1], Contains("generators: moved to the surface, by at most"));
  options.max_snap = 0.5 * distance;
  CHECK_THROWS_AS(choose(options), Error);
}

TEST_CASE("a mesh without the curves that a word stands for is refused") {
  GeneratorOptions options;
  Recorder told;
  options.curves.name = "boundary";
  CHECK_THROWS_WITH(choose_curves(kTorus, options, told), Contains("curves=boundary: the mesh is closed"));
  options.curves.name = "creases:170";
  CHECK_THROWS_WITH(choose_curves(kTorus, options, told),
                    Contains("no two faces meet at more than 170 degrees; ask for a smaller angle"));
}

}  // namespace gvd::test_generator_options
