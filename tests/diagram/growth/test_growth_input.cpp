#include <cmath>

#include "diagram/growth/growth_input.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/stages.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_growth_input {

/// A right triangle with legs 3 and 4, whose table a test fills in.
struct OneFace {
  Mesh mesh = test::make_mesh({{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}, {{0, 1, 2}});
  WorkingMesh working{mesh, test::at_vertices(mesh, {0})};
  GeneratorTable table{3, 1};
  NearestLabels labels{IdVector<VertexId, GeneratorId>(3), IdVector<VertexId, double>(3, kInfinity), {}};
  GrowthInput input{working, table, labels, Front::circle};

  void reach(int v, double distance) { table.add(VertexId(v), GeneratorId(0), distance, HalfedgeId()); }
};

TEST_CASE("a generator that no corner knows is infinitely far") {
  const OneFace face;
  CHECK(corner_distances(face.input, FaceId(0), GeneratorId(0)) ==
        std::array<double, 3>{kInfinity, kInfinity, kInfinity});
}

TEST_CASE("a corner without a distance is reached along the edges from those that have one") {
  OneFace face;
  face.reach(0, 1);
  CHECK(corner_distances(face.input, FaceId(0), GeneratorId(0)) == std::array<double, 3>{1, 4, 5});
  face.reach(1, 2);
  CHECK(corner_distances(face.input, FaceId(0), GeneratorId(0)) == std::array<double, 3>{1, 2, 5});
  face.reach(2, 0.5);
  CHECK(corner_distances(face.input, FaceId(0), GeneratorId(0)) == std::array<double, 3>{1, 2, 0.5});
}

TEST_CASE("the distance of a label counts where it is smaller than the table's") {
  OneFace face;
  face.reach(0, 1);
  face.labels.label[VertexId(0)] = face.labels.label[VertexId(1)] = GeneratorId(0);
  face.labels.distance[VertexId(0)] = 2;
  face.labels.distance[VertexId(1)] = 0.25;
  CHECK(corner_distances(face.input, FaceId(0), GeneratorId(0)) == std::array<double, 3>{1, 0.25, 5});
  CHECK(corner_distances(face.input, FaceId(0), GeneratorId(1)) ==
        std::array<double, 3>{kInfinity, kInfinity, kInfinity});
}

TEST_CASE("corner distances differ by no more than the edges allow, and labels are among them") {
  const Mesh mesh = test::make_bumpy_sphere(3, 5);
  const test::Stages stages(mesh, test::random_generators(mesh, 30, 6), Front::circle);
  for (int f = 0; f < stages.mesh().face_count(); ++f) {
    const auto& corners = stages.mesh().vertices(FaceId(f));
    const GeneratorId own = stages.labels.label[corners[0]];
    const auto d = corner_distances(stages.input(), FaceId(f), own);
    REQUIRE(d[0] <= stages.labels.distance[corners[0]]);
    for (const double x : d) REQUIRE(std::isfinite(x));
  }
}

}  // namespace gvd::test_growth_input
