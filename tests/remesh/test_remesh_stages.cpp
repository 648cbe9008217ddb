#include "gvd/remesh.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

namespace gvd::test_remesh_stages {

TEST_CASE(
    "a remesh announces its stages in turn, a diagram and its dual in every round, then placement, search and "
    "distances") {
  const Mesh mesh = test::make_torus(24, 12);
  RemeshOptions options;
  std::vector<RemeshStage> stages;
  options.on_stage = [&stages](RemeshStage stage) { stages.push_back(stage); };
  const RemeshResult result = remesh(mesh, test::random_generators(mesh, 2, 1), options);
  CHECK(result.rounds > 1);
  REQUIRE(stages.size() == 2 * static_cast<std::size_t>(result.rounds) + 3);
  CHECK(stages[stages.size() - 3] == RemeshStage::placement);
  CHECK(stages[stages.size() - 2] == RemeshStage::search);
  CHECK(stages.back() == RemeshStage::distance);
  for (std::size_t i = 0; i + 3 < stages.size(); ++i) {
    CHECK(stages[i] == (i % 2 == 0 ? RemeshStage::diagram : RemeshStage::dual));
  }
}

}  // namespace gvd::test_remesh_stages
