#include <cmath>

#include "creases/crease_gaps.hpp"
#include "remesh/creases/crease_meshes.hpp"
#include "support/catch.hpp"

using namespace gvd;

namespace {

/// A flat square of side 4 whose boundary is one curve, or four between its corners.
struct Square {
  Mesh mesh = test::make_grid(4, 4);
  std::vector<CreaseCurve> curves = trace_creases(mesh, find_creases(mesh, {180, true}));

  VertexId at(double x, double y) const {
    for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) {
      if ((mesh.position(VertexId(v)) - Vec3(x, y, 0)).norm() < 1e-9) return VertexId(v);
    }
    return {};
  }
  std::vector<CreaseGap> gaps(const std::vector<Vec3>& generators) const {
    std::vector<SurfacePoint> points;
    for (const Vec3& p : generators) points.push_back(vertex_point(mesh, at(p.x(), p.y())));
    return CreaseGaps(mesh, curves, compute_diagram(mesh, points)).find();
  }
};

}  // namespace

TEST_CASE("crease gaps: corners without a generator come first") {
  const Square square;
  REQUIRE(square.curves.size() == 4);
  const auto gaps = square.gaps({{2, 2, 0}});
  REQUIRE(gaps.size() == 8);  // both ends of each side
  for (const CreaseGap& gap : gaps) {
    CHECK(std::isinf(gap.length));
    CHECK(gap.place.kind() == SurfacePoint::Kind::vertex);
  }
}

TEST_CASE("crease gaps: none where each point of a side belongs to the nearest generators on it") {
  const Square square;
  const std::vector<Vec3> corners{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
  CHECK(square.gaps(corners).empty());
  std::vector<Vec3> inside = corners;
  inside.emplace_back(2, 2, 0);  // its cell touches each side in a point
  CHECK(square.gaps(inside).empty());
}

TEST_CASE("crease gaps: the point opposite to a foreign generator, with the length of its cell on the crease") {
  const Square square;
  const auto gaps = square.gaps({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {2, 1, 0}});
  REQUIRE(gaps.size() == 1);
  CHECK((position(square.mesh, gaps[0].place) - Vec3(2, 0, 0)).norm() < 1e-9);
  // Points of the side as far from (2, 1) as from the nearer corner: x = 5 / 4 and 11 / 4.
  CHECK(gaps[0].length == Approx(1.5));
}

TEST_CASE("crease gaps: next to a corner, a power of two away from it where a crease of the corner is in the way") {
  const Mesh sector = test::make_sector(2, 0.3);
  const auto curves = trace_creases(sector, find_creases(sector, {180, true}));
  std::vector<SurfacePoint> generators = place_on_creases(sector, find_creases(sector, {180, true}), 10).points;
  // On one of the two straight sides, at 0.4.
  for (std::int32_t e = 0; e < sector.edge_count(); ++e) {
    const HalfedgeId h = sector.halfedge(EdgeId(e));
    if (sector.twin(h).valid() || sector.position(sector.from(h)).norm() > 1e-9) continue;
    generators.push_back(edge_point(h, 0.4));
  }
  const auto gaps = CreaseGaps(sector, curves, compute_diagram(sector, generators)).find();
  REQUIRE(gaps.size() == 1);
  CHECK(position(sector, gaps[0].place).norm() == Approx(0.5));
}

TEST_CASE("crease gaps: a closed curve takes thirds until it has three generators") {
  const Mesh can = test::make_can(24, 3);
  const auto curves = trace_creases(can, find_creases(can, {40}));
  REQUIRE(curves.size() == 2);
  CHECK(curves[0].closed);
  const auto gaps = CreaseGaps(can, curves, compute_diagram(can, {vertex_point(can, VertexId(0))})).find();
  CHECK(gaps.size() == 2 + 3);
}
