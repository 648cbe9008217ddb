#include <limits>

#include "border_forest.hpp"
#include "gvd/segment.hpp"
#include "segment/two_pieces.hpp"
#include "smooth_borders.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/random.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_border_forest {

constexpr GeneratorId kA(0), kB(1);

/// A square of two faces; both are cut, and generator 1 lies in face 1.
struct Square {
  Mesh mesh = test::make_grid(1, 1);
  Diagram diagram =
      test::make_whole_diagram(mesh, {vertex_point(mesh, VertexId(1)), make_surface_point(FaceId(1), {0.2, 0.3, 0.5})});
  IdVector<FaceId, GeneratorId> label{std::vector<GeneratorId>{kB, kB}};

  Square() {
    test::cut_in_two(diagram, FaceId(0), 0.5, kA, kB);
    test::cut_in_two(diagram, FaceId(1), 0.5, kA, kB);
  }
};

TEST_CASE("free faces: without cut faces there are none") {
  const Mesh mesh = test::make_grid(1, 1);
  const Diagram diagram = test::make_whole_diagram(mesh, {vertex_point(mesh, VertexId(0))});
  const FaceShares shares(diagram);
  CHECK(FreeFaces(mesh, diagram, shares, diagram.face_label).count() == 0);
}

TEST_CASE("free faces: the face of a generator keeps its label, another cut face is free") {
  const Square square;
  const FaceShares shares(square.diagram);
  const FreeFaces free(square.mesh, square.diagram, shares, square.label);
  REQUIRE(free.count() == 1);
  const FreeFaceId only(0);
  CHECK(free.face(only) == FaceId(0));
  CHECK(free.find(FaceId(0)) == only);
  CHECK_FALSE(free.find(FaceId(1)).valid());
  REQUIRE(free.candidates(only).size() == 2);
  CHECK(free.candidates(only)[0].generator == kB);
  CHECK(free.first_fraction(only) == Approx(0.75));
}

TEST_CASE("free faces: one face of a generator at a vertex keeps its label, that with the largest share") {
  const Square square;
  Diagram diagram = square.diagram;
  diagram.generators = {vertex_point(square.mesh, VertexId(0))};
  diagram.pieces.clear();
  test::cut_in_two(diagram, FaceId(0), 0.5, kA, kB);
  test::cut_in_two(diagram, FaceId(1), 0.6, kA, kB);
  diagram.generators.push_back(vertex_point(square.mesh, VertexId(1)));
  const FaceShares shares(diagram);
  const IdVector<FaceId, GeneratorId> label(std::vector<GeneratorId>{kA, kA});
  const FreeFaces free(square.mesh, diagram, shares, label);
  REQUIRE(free.count() == 1);
  CHECK(free.face(FreeFaceId(0)) == FaceId(0));
}

TEST_CASE("free faces: a piece without area is no share") {
  Square square;
  square.diagram.pieces.clear();
  test::cut_in_two(square.diagram, FaceId(0), 0, kA, kB);
  const FaceShares shares(square.diagram);
  CHECK(FreeFaces(square.mesh, square.diagram, shares, square.label).count() == 0);
}

TEST_CASE("free faces: a label without a share has the first fraction 0") {
  Square square;
  square.diagram.generators.push_back(vertex_point(square.mesh, VertexId(2)));
  square.label[FaceId(0)] = GeneratorId(2);
  square.label[FaceId(1)] = GeneratorId(2);
  const FaceShares shares(square.diagram);
  const FreeFaces free(square.mesh, square.diagram, shares, square.label);
  REQUIRE(free.count() == 1);  // one of the two holds generator 2
  CHECK(free.first_fraction(FreeFaceId(0)) == 0);
}

using Labels = IdVector<FaceId, GeneratorId>;

/// A mesh whose faces, all but the first one, are cut between two of three generators at random.
struct RandomCuts {
  Mesh mesh;
  Diagram diagram;
  Labels label;

  RandomCuts(Mesh m, unsigned seed) : mesh(std::move(m)) {
    diagram = test::make_whole_diagram(mesh, {make_surface_point(FaceId(0), {0.2, 0.3, 0.5})});
    diagram.generators.resize(3, diagram.generators[0]);
    test::Random random(seed);
    label.assign(diagram.face_label.size(), GeneratorId(0));
    for (int f = 1; f < mesh.face_count(); ++f) {
      const int tip = random.below(3), rest = (tip + 1 + random.below(2)) % 3;
      const double t = random.real(0.3, 0.95);
      test::cut_in_two(diagram, FaceId(f), t, GeneratorId(tip), GeneratorId(rest));
      label[FaceId(f)] = GeneratorId(t * t >= 0.5 ? tip : rest);
    }
  }
};

/// The cost of all labels, from its definition.
double cost(const Mesh& mesh, const FreeFaces& free, const BorderCosts& costs, const Labels& label) {
  double sum = compute_border_length(mesh, label);
  for (int i = 0; i < free.count(); ++i) {
    for (const FaceShare& share : free.candidates(FreeFaceId(i))) {
      if (share.generator == label[free.face(FreeFaceId(i))]) sum += costs.of_share(FreeFaceId(i), share.fraction);
    }
  }
  return sum;
}

/// The least cost of all labels, tried one after the other.
double least_cost(const Mesh& mesh, const FreeFaces& free, const BorderCosts& costs, Labels label, int next = 0) {
  if (next == free.count()) return cost(mesh, free, costs, label);
  double least = std::numeric_limits<double>::infinity();
  for (const FaceShare& share : free.candidates(FreeFaceId(next))) {
    label[free.face(FreeFaceId(next))] = share.generator;
    least = std::min(least, least_cost(mesh, free, costs, label, next + 1));
  }
  return least;
}

TEST_CASE("border forest: nothing to choose") {
  const Mesh mesh = test::make_triangle();
  const Diagram diagram = test::make_whole_diagram(mesh, {vertex_point(mesh, VertexId(0))});
  const FaceShares shares(diagram);
  const FreeFaces free(mesh, diagram, shares, diagram.face_label);
  const BorderCosts costs(mesh, free, diagram.face_label);
  CHECK(BorderForest(free, costs, diagram.face_label, 1).choose(FreeFaceId(0)).empty());
}

TEST_CASE("border forest: on a strip, which has no cycle, the labels have the least cost of all") {
  for (unsigned seed = 0; seed < 60; ++seed) {
    const RandomCuts cuts(test::make_jittered_grid(5, 1, 0.2, seed), seed);
    const FaceShares shares(cuts.diagram);
    const FreeFaces free(cuts.mesh, cuts.diagram, shares, cuts.label);
    const BorderCosts costs(cuts.mesh, free, cuts.label);
    BorderForest forest(free, costs, cuts.label, 3);
    const double least = least_cost(cuts.mesh, free, costs, cuts.label);
    for (const int first : {0, 3, free.count() - 1}) {
      CAPTURE(seed, first);
      Labels label = cuts.label;
      const auto& chosen = forest.choose(FreeFaceId(first));
      for (int i = 0; i < free.count(); ++i) label[free.face(FreeFaceId(i))] = chosen[FreeFaceId(i)];
      CHECK(cost(cuts.mesh, free, costs, label) == Approx(least));
    }
  }
}

TEST_CASE("border forest: with cycles the cost is between the least and the present one") {
  for (unsigned seed = 0; seed < 30; ++seed) {
    for (const Mesh& mesh : {test::make_tetrahedron(), test::make_grid(2, 2), test::make_pillow()}) {
      const RandomCuts cuts(mesh, seed);
      const FaceShares shares(cuts.diagram);
      const FreeFaces free(cuts.mesh, cuts.diagram, shares, cuts.label);
      const BorderCosts costs(cuts.mesh, free, cuts.label);
      BorderForest forest(free, costs, cuts.label, 3);
      for (int first = 0; first < free.count(); ++first) {
        CAPTURE(seed, first, mesh.face_count());
        Labels label = cuts.label;
        const auto& chosen = forest.choose(FreeFaceId(first));
        for (int i = 0; i < free.count(); ++i) label[free.face(FreeFaceId(i))] = chosen[FreeFaceId(i)];
        const double found = cost(cuts.mesh, free, costs, label), present = cost(cuts.mesh, free, costs, cuts.label);
        CHECK(found <= present * (1 + 1e-12));
        CHECK(found >= least_cost(cuts.mesh, free, costs, cuts.label) * (1 - 1e-12));
        CHECK(present == Approx(compute_border_length(cuts.mesh, cuts.label)));  // the first labels cost their border
      }
    }
  }
}

}  // namespace gvd::test_border_forest
