#include "kept_creases.hpp"
#include "support/catch.hpp"

namespace gvd::test_kept_creases {

using namespace bench;

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

}  // namespace gvd::test_kept_creases
