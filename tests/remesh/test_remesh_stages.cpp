#include "gvd/remesh.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

using namespace gvd;

TEST_CASE("a remesh announces its stages in turn, a diagram and its dual in every round") {
  const Mesh mesh = test::make_torus(16, 8);
  RemeshOptions options;
  std::vector<RemeshStage> stages;
  options.on_stage = [&stages](RemeshStage stage) { stages.push_back(stage); };
  const RemeshResult result =
      remesh(mesh, {vertex_point(mesh, VertexId(0)), vertex_point(mesh, VertexId(40))}, options);
  CHECK(result.rounds > 1);
  REQUIRE(stages.size() == 2 * static_cast<std::size_t>(result.rounds));
  for (std::size_t i = 0; i < stages.size(); ++i) {
    CHECK(stages[i] == (i % 2 == 0 ? RemeshStage::diagram : RemeshStage::dual));
  }
}
