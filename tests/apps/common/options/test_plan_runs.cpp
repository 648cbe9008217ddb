#include "common/options/plan_runs.hpp"
#include "support/catch.hpp"

namespace gvd::test_plan_runs {

using namespace app;

TEST_CASE("each input has a run, with files of its name in the folder") {
  Options options;
  options.input.paths = {"a/x.ply", "y.z.obj"};
  options.input.path = "a/x.ply";
  options.output.folder = "out";
  options.output.formats = {"ply", "json"};
  const std::vector<Options> runs = plan_runs(options);
  REQUIRE(runs.size() == 2);
  CHECK(runs[0].input.path == "a/x.ply");
  CHECK(runs[0].output.files == std::vector<std::string>{"out/x.ply", "out/x.json"});
  CHECK(runs[1].input.path == "y.z.obj");
  CHECK(runs[1].output.files == std::vector<std::string>{"out/y.z.ply", "out/y.z.json"});
}

TEST_CASE("without a folder the outputs are those of the command line") {
  Options options;
  options.input.paths = {"x.ply"};
  options.output.files = {"a.obj"};
  CHECK(plan_runs(options).front().output.files == std::vector<std::string>{"a.obj"});
}

}  // namespace gvd::test_plan_runs
