#include "face_shares.hpp"
#include "gvd/error.hpp"
#include "segment/restricted_voronoi.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_face_shares {

constexpr std::array<double, 3> kA{1, 0, 0}, kB{0, 1, 0}, kC{0, 0, 1}, kAB{0.5, 0.5, 0}, kAC{0.5, 0, 0.5};

FacePiece make_piece(int face, int generator, std::vector<std::array<double, 3>> corners) {
  return {FaceId(face), GeneratorId(generator), std::move(corners)};
}

TEST_CASE("face shares: the fraction of a piece without area is 0, of a whole face 1") {
  CHECK(compute_area_fraction(make_piece(0, 0, {})) == 0);
  CHECK(compute_area_fraction(make_piece(0, 0, {kA, kB})) == 0);
  CHECK(compute_area_fraction(make_piece(0, 0, {kA, kC, kB})) == 0);  // clockwise by rounding: clamped
  CHECK(compute_area_fraction(make_piece(0, 0, {kA, kB, kC})) == 1);
  CHECK(compute_area_fraction(make_piece(0, 0, {kA, kAB, kAC})) == Approx(0.25));
}

TEST_CASE("face shares: a face that is not cut has none") {
  Diagram diagram;
  const FaceShares none(diagram);
  CHECK(none.all().empty());
  CHECK(none.of(FaceId(0)).empty());
  CHECK(none.fraction(FaceId(0), GeneratorId(0)) == 0);
}

TEST_CASE("face shares: pieces of one cell are added up, and the largest share comes first") {
  Diagram diagram;
  const std::array<double, 3> centre{0.5, 0.25, 0.25};
  diagram.pieces = {make_piece(2, 1, {kA, kAB, centre}), make_piece(2, 0, {kAB, kB, kC, centre}),
                    make_piece(2, 1, {kA, centre, kAC}), make_piece(2, 0, {centre, kC, kAC}),
                    make_piece(5, 3, {kA, kB, kAC}),     make_piece(5, 2, {kAC, kB, kC})};
  const FaceShares shares(diagram);
  REQUIRE(shares.all().size() == 4);
  REQUIRE(shares.of(FaceId(2)).size() == 2);
  CHECK(shares.of(FaceId(2))[0].generator == GeneratorId(0));
  CHECK(shares.fraction(FaceId(2), GeneratorId(0)) == Approx(0.75));
  CHECK(shares.fraction(FaceId(2), GeneratorId(1)) == Approx(0.25));
  CHECK(shares.fraction(FaceId(2), GeneratorId(2)) == 0);
  // Two equal halves: the smaller generator first.
  CHECK(shares.of(FaceId(5))[0].generator == GeneratorId(2));
}

TEST_CASE("face shares: the shares of every cut face sum to 1, in descending order") {
  for (const auto& [name, mesh] : test::small_family()) {
    CAPTURE(name);
    const Diagram diagram = test::make_restricted_voronoi(mesh, test::random_generators(mesh, 20, 3));
    const FaceShares shares(diagram);
    for (int f = 0; f < mesh.face_count(); ++f) {
      const auto of_face = shares.of(FaceId(f));
      if (of_face.empty()) continue;
      double sum = 0;
      for (std::size_t i = 0; i < of_face.size(); ++i) {
        sum += of_face[i].fraction;
        if (i > 0) CHECK(of_face[i].fraction <= of_face[i - 1].fraction);
      }
      CHECK(sum == Approx(1).epsilon(1e-9));
    }
  }
}

TEST_CASE("face shares: a diagram with sizes or ids of another mesh is refused") {
  const Mesh mesh = test::make_pillow();
  Diagram good;
  good.generators = {vertex_point(mesh, VertexId(0))};
  good.face_label.assign(2, GeneratorId(0));
  CHECK_NOTHROW(check_belongs(mesh, good));
  const auto refused = [&](auto change) {
    Diagram bad = good;
    change(bad);
    CHECK_THROWS_AS(check_belongs(mesh, bad), Error);
  };
  refused([](Diagram& d) { d.face_label.assign(1, GeneratorId(0)); });
  refused([](Diagram& d) { d.face_label[FaceId(1)] = GeneratorId(1); });
  refused([](Diagram& d) { d.generators[0].face = FaceId(2); });
  refused([](Diagram& d) { d.pieces.push_back(make_piece(2, 0, {kA, kB, kC})); });
  refused([](Diagram& d) { d.pieces.push_back(make_piece(0, -1, {kA, kB, kC})); });
}

}  // namespace gvd::test_face_shares
