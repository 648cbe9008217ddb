#include "integrals/cell_faces.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

using namespace gvd;

TEST_CASE("cell faces: a diagram without faces has cells without any") {
  Diagram diagram;
  diagram.generators.resize(2);
  const CellFaces cells(diagram);
  CHECK(cells.cell_count() == 2);
  CHECK(cells.of(GeneratorId(0)).empty());
  CHECK(cells.of(GeneratorId(1)).empty());
}

TEST_CASE("cell faces: whole faces come before clipped ones, and faces without a generator are left out") {
  Diagram diagram;
  diagram.generators.resize(2);
  for (const int label : {1, -1, 0, -1, 1}) diagram.face_label.push_back(GeneratorId(label));
  diagram.pieces = {{FaceId(1), GeneratorId(1), {}}, {FaceId(1), GeneratorId(0), {}}, {FaceId(1), GeneratorId(1), {}}};
  const CellFaces cells(diagram);
  REQUIRE(cells.of(GeneratorId(0)).size() == 2);
  CHECK(cells.of(GeneratorId(0))[0].face == FaceId(2));
  CHECK(cells.of(GeneratorId(0))[1].piece == &diagram.pieces[1]);
  const auto second = cells.of(GeneratorId(1));
  REQUIRE(second.size() == 4);
  CHECK(second[0].face == FaceId(0));
  CHECK(second[0].piece == nullptr);
  CHECK(second[1].face == FaceId(4));
  CHECK(second[2].piece == &diagram.pieces[0]);
  CHECK(second[3].piece == &diagram.pieces[2]);
}

TEST_CASE("cell faces: every face and every piece belongs to one cell") {
  for (const auto& [name, mesh] : test::small_family()) {
    CAPTURE(name);
    const Diagram diagram = compute_diagram(mesh, test::random_generators(mesh, 9, 1));
    const CellFaces cells(diagram);
    std::size_t whole = 0, clipped = 0, labelled = 0;
    for (std::size_t g = 0; g < cells.cell_count(); ++g) {
      const GeneratorId id(static_cast<std::int64_t>(g));
      for (const CellFace& face : cells.of(id)) {
        ++(face.piece ? clipped : whole);
        CHECK((face.piece ? face.piece->generator : diagram.face_label[face.face]) == id);
      }
    }
    for (const GeneratorId g : diagram.face_label) labelled += g.valid();
    CHECK(whole == labelled);
    CHECK(clipped == diagram.pieces.size());
  }
}
