#include <cmath>

#include "gvd/error.hpp"
#include "integrals/cell_faces.hpp"
#include "integrals/cell_integrals.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

using namespace gvd;

namespace {

std::vector<CellFace> whole_faces(const Mesh& mesh) {
  std::vector<CellFace> faces;
  for (int f = 0; f < mesh.face_count(); ++f) faces.push_back({FaceId(f), nullptr});
  return faces;
}

}  // namespace

TEST_CASE("squared distance: exact for a source in the plane of the triangle") {
  const std::array<Vec2, 3> corner{Vec2(0, 0), Vec2(3, 0.5), Vec2(1, 2)};
  for (const Vec2& source : {Vec2(0, 0), Vec2(1, 1), Vec2(-4, 7)}) {
    SquaredDistance squared{};
    for (std::size_t i = 0; i < 3; ++i) {
      squared.corner[i] = (corner[i] - source).squaredNorm();
      squared.side[i] = (corner[(i + 1) % 3] - corner[i]).squaredNorm();
    }
    for (const auto& b : {std::array{1.0, 0.0, 0.0}, std::array{0.5, 0.5, 0.0}, std::array{0.2, 0.3, 0.5}}) {
      const Vec2 p = b[0] * corner[0] + b[1] * corner[1] + b[2] * corner[2];
      CHECK(squared.at(b) == Approx((p - source).squaredNorm()).margin(1e-14));
    }
  }
}

TEST_CASE("squared distance: distances that no source in the plane has give no negative value") {
  const SquaredDistance squared{{0.01, 0.01, 0.01}, {1, 1, 1}};
  CHECK(squared.at({1.0 / 3, 1.0 / 3, 1.0 / 3}) == 0);
  CHECK(squared.at({1, 0, 0}) == Approx(0.01));
}

TEST_CASE("cell integrals: a cell without faces, and one of faces without area") {
  const Mesh grid = test::make_grid(1, 1);
  CellIntegrals integrals(grid);
  const CellMoments nothing = integrals.compute(vertex_point(grid, VertexId(0)), {});
  CHECK(nothing.area == 0);
  CHECK(nothing.energy == 0);
  CHECK(nothing.centroid == Vec2::Zero());
  const Mesh flat = test::make_mesh({{0, 0, 0}, {2, 0, 0}, {1, 0, 0}}, {{0, 1, 2}});
  const CellMoments line = CellIntegrals(flat).compute(vertex_point(flat, VertexId(0)), whole_faces(flat));
  CHECK(std::isfinite(line.centroid.norm()));
  CHECK(line.energy == Approx(0).margin(1e-9));
}

TEST_CASE("cell integrals: clipped faces add up to the whole face") {
  const Mesh mesh = test::make_triangle();
  const FacePiece half{FaceId(0), GeneratorId(0), {{1, 0, 0}, {0.5, 0.5, 0}, {0, 0, 1}}};
  const FacePiece rest{FaceId(0), GeneratorId(0), {{0.5, 0.5, 0}, {0, 1, 0}, {0, 0, 1}}};
  const std::vector<CellFace> clipped{{FaceId(0), &half}, {FaceId(0), &rest}};
  CellIntegrals integrals(mesh);
  for (const SurfacePoint& origin : test::random_generators(mesh, 9, 3)) {
    const CellMoments sum = integrals.compute(origin, clipped), whole = integrals.compute(origin, whole_faces(mesh));
    CHECK(sum.area == Approx(whole.area));
    CHECK(sum.energy == Approx(whole.energy));
    CHECK((sum.centroid - whole.centroid).norm() < 1e-12);
  }
}

TEST_CASE("cell integrals: a piece that is not convex counts its fan with signs") {
  const Mesh mesh = test::make_triangle();
  const std::array<double, 3> dent{0.4, 0.3, 0.3};
  const FacePiece piece{FaceId(0), GeneratorId(0), {{0, 0, 1}, {1, 0, 0}, dent, {0, 1, 0}}};
  const FacePiece missing{FaceId(0), GeneratorId(0), {{1, 0, 0}, {0, 1, 0}, dent}};
  const std::vector<CellFace> both{{FaceId(0), &piece}, {FaceId(0), &missing}};
  CellIntegrals integrals(mesh);
  const SurfacePoint origin = make_surface_point(FaceId(0), {0.2, 0.2, 0.6});
  const CellMoments sum = integrals.compute(origin, both), whole = integrals.compute(origin, whole_faces(mesh));
  CHECK(sum.area == Approx(whole.area));
  CHECK(sum.energy == Approx(whole.energy));
  const std::vector<CellFace> dented{{FaceId(0), &piece}};
  CHECK(integrals.compute(origin, dented).area == Approx(0.7 * whole.area));
}

TEST_CASE("cell integrals: the generator may lie outside of the cell's faces") {
  const Mesh strip = test::make_grid(6, 1);
  const std::vector<CellFace> end{{FaceId(10), nullptr}, {FaceId(11), nullptr}};
  const CellMoments m = CellIntegrals(strip).compute(vertex_point(strip, VertexId(0)), end);
  CHECK(m.area == Approx(1));
  CHECK(m.centroid.norm() == Approx(std::hypot(5.5, 0.5)).epsilon(1e-6));
}

TEST_CASE("cell moments: the areas are those of the cells; another mesh's diagram is refused") {
  for (const auto& [name, mesh] : test::small_family()) {
    CAPTURE(name);
    const Diagram diagram = compute_diagram(mesh, test::random_generators(mesh, 7, 4));
    const auto moments = compute_cell_moments(mesh, diagram);
    for (const Cell& cell : diagram.cells) {
      CHECK(moments[cell.generator].area == Approx(cell.area).epsilon(1e-9));
      CHECK(moments[cell.generator].energy > 0);
    }
  }
  const Mesh grid = test::make_grid(2, 2);
  const Diagram diagram = compute_diagram(grid, {vertex_point(grid, VertexId(0))});
  CHECK_THROWS_AS(compute_cell_moments(test::make_grid(3, 3), diagram), Error);
}
