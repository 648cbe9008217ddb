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
  CHECK(figures->least_angle < figures->angle);
  CHECK(figures->below_30 < 50);
  CHECK(figures->intersections == 0);
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
  CHECK(followed->creases_kept > 90);
  CHECK(free->creases_kept < followed->creases_kept);
}

TEST_CASE("a run that fails has no figures") {
  const Mesh torus = read_named_mesh(kTorus).mesh;
  CHECK_FALSE(run_remesh(torus, {"no file's.obj", 100, std::nullopt}));
}

/// Eight corners of a cube, whose upper four are turned by `turn` (of the edge's length) along the edges.
Mesh make_cube(double turn = 0) {
  std::vector<Vec3> p{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  for (std::size_t i = 4; i < 8; ++i) p[i].x() += turn;
  const int faces[12][3]{{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}, {0, 1, 5}, {0, 5, 4},
                         {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};
  std::vector<std::array<VertexId, 3>> ids;
  for (const auto& f : faces) ids.push_back({VertexId(f[0]), VertexId(f[1]), VertexId(f[2])});
  return Mesh(std::move(p), std::move(ids));
}

TEST_CASE("a cube keeps all creases of itself") { CHECK(percent_of_creases_kept(make_cube(), make_cube()) == 100); }

TEST_CASE("creases that are moved farther than the distance are not kept") {
  const Mesh cube = make_cube(), sheared = make_cube(0.1);
  // The four upper edges move along x: two of them along themselves. The four upright ones turn by 6 degrees and move.
  CHECK(percent_of_creases_kept(cube, sheared) == Approx(100 * 6.0 / 12));
  KeptCreaseOptions wide;
  wide.distance = 0.06;
  CHECK(percent_of_creases_kept(cube, sheared, wide) == 100);
  wide.direction = 3;
  CHECK(percent_of_creases_kept(cube, sheared, wide) == Approx(100 * 8.0 / 12));
}

TEST_CASE("a mesh without creases keeps them all, and one without is none of another's") {
  KeptCreaseOptions blunt;
  blunt.angle = 100;
  CHECK(percent_of_creases_kept(make_cube(), make_cube(), blunt) == 100);
  const Mesh triangle({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{VertexId(0), VertexId(1), VertexId(2)}});
  CHECK(percent_of_creases_kept(make_cube(), triangle) == 0);
}

}  // namespace gvd::test_remesh_run
