#include "collect_pieces.hpp"
#include "islands.hpp"
#include "pieces_of_faces.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

using namespace gvd;
using namespace gvd::paper;

namespace {

/// A strip of unit squares of two faces each: the label of square i is label[i].
Comparison collect_strip(const Mesh& mesh, const std::vector<int>& label, const std::vector<SurfacePoint>& generators) {
  Comparison result;
  auto pieces = test::whole_faces(mesh, [&](FaceId f) { return label[std::size_t(f.value() / 2)]; });
  collect_pieces(mesh, generators, std::move(pieces), result);
  return result;
}

/// The middle of the diagonal of a square of the strip.
SurfacePoint middle(int square) { return make_surface_point(FaceId(2 * square), {0.5, 0, 0.5}); }

}  // namespace

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
