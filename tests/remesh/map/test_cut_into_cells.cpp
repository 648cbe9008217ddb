// Borders of the cells of a labelled mesh: their loops and runs, and what is refused.
#include <cmath>

#include "gvd/error.hpp"
#include "map/cut_into_cells.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/refusal.hpp"

namespace gvd::test_cut_into_cells {

/// Labels of faces: a function of their centres.
template <class Function>
IdVector<FaceId, GeneratorId> label_faces(const Mesh& mesh, Function function) {
  IdVector<FaceId, GeneratorId> label;
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const auto& [a, b, c] = mesh.vertices(FaceId(f));
    label.push_back(GeneratorId(function((mesh.position(a) + mesh.position(b) + mesh.position(c)) / 3)));
  }
  return label;
}

/// Thirds of a sphere by their angle about the z axis.
int third(const Vec3& p) {
  const double angle = std::atan2(p.y(), p.x());
  return angle < -1.05 ? 0 : angle < 1.05 ? 1 : 2;
}

std::string refused(const Mesh& mesh, const IdVector<FaceId, GeneratorId>& label, std::size_t cells) {
  return test::refusal([&] { value_or_throw(trace_cell_borders(mesh, label, cells)); }, ErrorCode::no_valid_result);
}

TEST_CASE("cell borders: quarters of a square have two neighbours each, and the boundary comes last") {
  const Mesh grid = test::make_grid(4, 4);
  const auto label = label_faces(grid, [](const Vec3& p) { return p.y() > 2 ? 0 : p.x() > 2 ? 1 : 2; });
  const auto borders = value_or_throw(trace_cell_borders(grid, label, 3));
  for (std::int32_t g = 0; g < 3; ++g) {
    const CellBorder& border = borders[GeneratorId(g)];
    REQUIRE(border.runs.size() == 3);
    CHECK(border.at_boundary());
    CHECK(border.runs.back().end == border.loop.size());
    for (std::size_t i = 0; i < border.loop.size(); ++i) {
      const HalfedgeId h = border.loop[i], next = border.loop[(i + 1) % border.loop.size()];
      CHECK(label[Mesh::face(h)] == GeneratorId(g));
      CHECK(grid.to(h) == grid.from(next));
    }
  }
}

TEST_CASE("cell borders: cells that are no discs, or that touch twice, are refused") {
  const Mesh sphere = test::make_sphere(2), grid = test::make_grid(6, 6);
  const auto in_zones = label_faces(sphere, [](const Vec3& p) { return p.z() > 0.5 ? 1 : p.z() < -0.5 ? 2 : 0; });
  CHECK(refused(sphere, in_zones, 3) == "cell 0 is no disc of whole triangles");
  const auto in_stripes = label_faces(grid, [](const Vec3& p) { return p.x() < 2 ? 1 : p.x() < 4 ? 0 : 2; });
  CHECK(refused(grid, in_stripes, 3) == "cell 0 touches the boundary twice");
  const auto in_halves = label_faces(sphere, [](const Vec3& p) { return p.z() > 0 ? 1 : 0; });
  CHECK(refused(sphere, in_halves, 2) == "cell 0 has too few neighbours");
  CHECK_THAT(refused(sphere, label_faces(sphere, third), 2), Catch::Matchers::Contains("is in no cell"));
  CHECK(refused(sphere, label_faces(sphere, [](const Vec3&) { return 0; }), 1) ==
        "cell 0 is no disc of whole triangles");
}

}  // namespace gvd::test_cut_into_cells
