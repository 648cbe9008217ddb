#include "free_faces.hpp"
#include "segment/two_pieces.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_free_faces {

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

}  // namespace gvd::test_free_faces
