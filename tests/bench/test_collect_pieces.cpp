#include "bench/pieces_of_faces.hpp"
#include "pieces.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_collect_pieces {

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

SurfacePoint in_face(double v, double w) { return make_surface_point(FaceId(0), {1 - v - w, v, w}); }

Segment segment(int left, int right, const SurfacePoint& begin, const SurfacePoint& end) {
  return {GeneratorId(left), GeneratorId(right), begin, end};
}

TEST_CASE("segments of the same two cells are joined, in whatever order they come") {
  const Mesh mesh = test::make_triangle();
  const SurfacePoint a = in_face(0.5, 0), b = in_face(0.4, 0.2), c = in_face(0.3, 0.3), d = in_face(0.5, 0.5);
  const Chains chains = chain_segments(mesh, {segment(0, 1, b, c), segment(0, 1, a, b), segment(0, 1, c, d)});
  REQUIRE(chains.bisectors.size() == 1);
  CHECK(chains.bisectors[0].points == std::vector<SurfacePoint>{a, b, c, d});
  CHECK_FALSE(chains.bisectors[0].closed);
  CHECK(chains.open_ends == 0);
}

TEST_CASE("a closed chain does not repeat its first point") {
  const Mesh mesh = test::make_triangle();
  const SurfacePoint a = in_face(0.2, 0.2), b = in_face(0.4, 0.2), c = in_face(0.3, 0.4);
  const Chains chains = chain_segments(mesh, {segment(0, 1, a, b), segment(0, 1, b, c), segment(0, 1, c, a)});
  REQUIRE(chains.bisectors.size() == 1);
  CHECK(chains.bisectors[0].closed);
  CHECK(chains.bisectors[0].points.size() == 3);
}

TEST_CASE("three chains end at a branch point, and one alone inside a face is open") {
  const Mesh mesh = test::make_triangle();
  const SurfacePoint middle = in_face(0.3, 0.3);
  const Chains branched =
      chain_segments(mesh, {segment(0, 1, in_face(0.5, 0), middle), segment(1, 2, in_face(0.5, 0.5), middle),
                            segment(2, 0, in_face(0, 0.5), middle)});
  CHECK(branched.bisectors.size() == 3);
  CHECK(branched.open_ends == 0);
  CHECK(chain_segments(mesh, {segment(0, 1, in_face(0.5, 0), middle)}).open_ends == 1);
}

TEST_CASE("a chain goes on in the next face, and its points share faces") {
  const Mesh mesh = test::make_grid(1, 1);
  const HalfedgeId h = Mesh::halfedge(FaceId(0), 2), twin = mesh.twin(h);
  REQUIRE(twin.valid());
  const SurfacePoint here = edge_point(h, 0.25), there = edge_point(twin, 0.75);
  const SurfacePoint begin = make_surface_point(FaceId(0), {0.2, 0.6, 0.2});
  const SurfacePoint end = make_surface_point(FaceId(1), {0.2, 0.3, 0.5});
  const Chains chains = chain_segments(mesh, {segment(0, 1, begin, here), segment(0, 1, there, end)});
  REQUIRE(chains.bisectors.size() == 1);
  CHECK(chains.bisectors[0].points.size() == 3);
  CHECK(chains.open_ends == 2);
}

}  // namespace gvd::test_collect_pieces
