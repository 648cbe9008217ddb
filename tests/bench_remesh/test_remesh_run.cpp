#include "command_line.hpp"
#include "remesh_run.hpp"
#include "support/catch.hpp"

namespace gvd::test_remesh_run {

using namespace bench;

const std::string kTorus = GVD_SOURCE_DIR "/data/torus.ply";
const std::string kPlate = GVD_SOURCE_DIR "/data/plate.stl";

TEST_CASE("a run of the command has figures of its mesh and its costs") {
  const auto figures = run_remesh(read_named_mesh(kTorus).mesh, {kTorus, 100, std::nullopt});
  REQUIRE(figures);
  CHECK(figures->right_topology);
  CHECK(figures->inflation == Approx(1).epsilon(0.2));
  CHECK(figures->rms > 0);
  CHECK(figures->hausdorff > figures->rms);
  CHECK(figures->q > 0.5);
  CHECK(figures->angle > 20);
  CHECK(figures->angle <= 60);
  CHECK(figures->rounds >= 1);
  CHECK(figures->made_seconds > 0);
  CHECK(figures->made_seconds < figures->seconds);
  CHECK(figures->diagrams >= 0);
  CHECK(figures->diagrams < 100);
}

TEST_CASE("with --features the creases are kept, and without they are not") {
  const Mesh plate = read_named_mesh(kPlate).mesh;
  const auto followed = run_remesh(plate, {kPlate, 100, 40.0}), free = run_remesh(plate, {kPlate, 100, std::nullopt});
  REQUIRE(followed);
  REQUIRE(free);
  CHECK(followed->kept > 90);
  CHECK(free->kept < followed->kept);
}

TEST_CASE("a run that fails has no figures") {
  const Mesh torus = read_named_mesh(kTorus).mesh;
  CHECK_FALSE(run_remesh(torus, {"no file's.obj", 100, std::nullopt}));
}

}  // namespace gvd::test_remesh_run
