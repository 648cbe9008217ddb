#include "bench/pieces_of_faces.hpp"
#include "pieces/collect_pieces.hpp"
#include "pieces/islands.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_islands {

using namespace paper;

/// A strip of unit squares of two faces each: the label of square i is label[i].
Comparison collect_strip(const Mesh& mesh, const std::vector<int>& label, const std::vector<SurfacePoint>& generators) {
  Comparison result;
  auto pieces = test::whole_faces(mesh, [&](FaceId f) { return label[std::size_t(f.value() / 2)]; });
  collect_pieces(mesh, generators, std::move(pieces), result);
  return result;
}

/// The middle of the diagonal of a square of the strip.
SurfacePoint middle(int square) { return make_surface_point(FaceId(2 * square), {0.5, 0, 0.5}); }

TEST_CASE("a part of a cell without its generator is an island") {
  const Mesh mesh = test::make_grid(5, 1);
  const Comparison found = collect_strip(mesh, {0, 1, 0, 1, 1}, {middle(0), middle(4)});
  CHECK(found.faults.islands == 2);
  CHECK(found.faults.island_area == Approx(2));
  CHECK(found.faults.lost_generators == 0);
  CHECK(found.diagram.cells[GeneratorId(0)].components == 2);
  CHECK(found.diagram.cells[GeneratorId(1)].area == Approx(3));
  CHECK(found.diagram.bisectors.size() == 3);
  CHECK(found.diagram.length == Approx(3));
}

TEST_CASE("connected cells have no island, and bisectors may follow the edges") {
  const Mesh mesh = test::make_grid(5, 1);
  const Comparison found = collect_strip(mesh, {0, 0, 0, 1, 1}, {middle(0), middle(4)});
  CHECK(found.faults.islands == 0);
  CHECK(found.faults.open_ends == 0);
  REQUIRE(found.diagram.bisectors.size() == 1);
  CHECK(found.diagram.bisectors.begin()->points.size() == 2);
  CHECK(found.diagram.cells[GeneratorId(0)].neighbours == std::vector<GeneratorId>{GeneratorId(1)});
}

TEST_CASE("a generator in the cell of another one is lost, and pieces without a generator are counted") {
  const Mesh mesh = test::make_grid(5, 1);
  const Comparison found = collect_strip(mesh, {0, 0, -1, 1, 1}, {middle(0), middle(1)});
  CHECK(found.faults.lost_generators == 1);
  CHECK(found.faults.islands == 1);
  CHECK(found.faults.unowned_area == Approx(1));
}

TEST_CASE("a component that rounding leaves at a vertex is no island") {
  const Mesh mesh = test::make_grid(5, 1);
  for (const auto& [width, islands] : {std::pair(1e-12, 0), std::pair(1e-3, 1)}) {
    Pieces pieces = test::whole_faces(mesh, [](FaceId) { return 0; });
    const LinearForm corner{width, width - 1, width - 1}, rest{-width, 1 - width, 1 - width};
    pieces[0] = {FaceId(0), GeneratorId(0), clip_polygon(whole_face(), rest, true)};
    pieces.insert(pieces.begin(), {FaceId(0), GeneratorId(1), clip_polygon(whole_face(), corner, true)});
    Comparison result;
    collect_pieces(mesh, {middle(2), middle(4)}, std::move(pieces), result);
    CHECK(result.faults.islands == islands);
  }
}

TEST_CASE("a generator in the notch of a piece is not in it") {
  const Mesh mesh = test::make_triangle();
  const SurfacePoint generator = make_surface_point(FaceId(0), {0.3, 0.35, 0.35});
  const Polygon notched{{1, 0, 0}, {0, 1, 0}, {0.6, 0.2, 0.2}, {0, 0, 1}}, notch{{0, 1, 0}, {0, 0, 1}, {0.6, 0.2, 0.2}};
  const Pieces outside{{FaceId(0), GeneratorId(0), notched}, {FaceId(0), GeneratorId(1), notch}};
  CHECK(find_cell_parts(mesh, {generator}, outside, {}).has_generator == std::vector<char>{0, 0});
  const Pieces inside{{FaceId(0), GeneratorId(1), notched}, {FaceId(0), GeneratorId(0), notch}};
  CHECK(find_cell_parts(mesh, {generator}, inside, {}).has_generator == std::vector<char>{0, 1});
}

}  // namespace gvd::test_islands
