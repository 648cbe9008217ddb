#include "apps/common/run_fixture.hpp"
#include "apps/run_command.hpp"
#include "common/run_parts.hpp"
#include "gvd/error.hpp"
#include "support/catch.hpp"

namespace gvd::test_choose_generators {

using namespace app;
using Catch::Matchers::Contains;
using gvd::test::QuietRun;

/// The generators of a run on the torus, and what it reports.
struct Made {
  explicit Made(const GeneratorOptions& generators) : quiet(options_of(generators)) {
    input = load_input(quiet.run);
    points = make_generators(quiet.run, input);
  }

  static Options options_of(const GeneratorOptions& generators) {
    Options options;
    options.input.path = test::data_file("torus.ply");
    options.generators = generators;
    return options;
  }

  QuietRun quiet;
  CheckedMesh input;
  std::vector<SurfacePoint> points;
};

TEST_CASE("a number of generators gives exactly as many, by every kind of sampling, and reports them") {
  for (const SamplingKind kind :
       {SamplingKind::farthest, SamplingKind::random, SamplingKind::vertices, SamplingKind::poisson}) {
    GeneratorOptions options;
    options.count = 12;
    options.sampling = kind;
    Made made(options);
    CHECK(made.points.size() == 12);
    const auto report = made.quiet.report();
    REQUIRE(report["generators"].size() == 12);
    for (std::size_t i = 0; i < 12; ++i) CHECK(report["generators"][i]["face"] == made.points[i].face.value());
    CHECK(report["timings_ms"].contains("generators"));
  }
}

TEST_CASE("a radius gives as many as it takes, and the seed changes a random choice") {
  GeneratorOptions radius;
  radius.radius = 1;
  const std::size_t few = Made(radius).points.size();
  radius.radius = 0.5;
  CHECK(Made(radius).points.size() > few);
  GeneratorOptions random;
  random.count = 5;
  random.sampling = SamplingKind::random;
  const auto first = Made(random).points;
  CHECK(Made(random).points == first);
  random.seed = 1;
  CHECK(Made(random).points != first);
}

TEST_CASE("vertices are those of the input, and an error names the option") {
  GeneratorOptions options;
  options.vertices = {3, 17};
  Made made(options);
  REQUIRE(made.points.size() == 2);
  CHECK(vertex(made.input.mesh, made.points[1]) == VertexId(17));
  options.vertices = {3, 3};
  CHECK_THROWS_WITH(Made(options), Contains("--vertices: generator 1 is in the same place as generator 0"));
  options.merge_coincident = true;
  CHECK(Made(options).points.size() == 1);
}

TEST_CASE("a position in a file is snapped, within the distance that is allowed") {
  const test::ScratchFolder scratch;
  test::write_text(scratch / "list.txt", "p 0 0 5\n");
  GeneratorOptions options;
  options.file = scratch / "list.txt";
  Made made(options);
  const double distance = made.quiet.report()["generators"][0]["snap_distance"].get<double>();
  CHECK(distance > 1);
  options.max_snap = 0.5 * distance;
  CHECK_THROWS_AS(Made(options), Error);
}

}  // namespace gvd::test_choose_generators
