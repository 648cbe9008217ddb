#include <algorithm>
#include <cmath>
#include <numbers>

#include "creases/crease_gaps.hpp"
#include "creases/follow_creases.hpp"
#include "remesh/creases/crease_meshes.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"

namespace gvd::test_crease_gaps {

/// A spacing with which no bend counts.
constexpr double kWide = 100;

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
    return CreaseGaps(mesh, curves, compute_diagram(mesh, points), kWide).find();
  }
};

double total_length(const std::vector<CreaseGap>& gaps) {
  double sum = 0;
  for (const CreaseGap& gap : gaps) sum += gap.length;
  return sum;
}

TEST_CASE("crease gaps: corners without a generator come first") {
  const Square square;
  REQUIRE(square.curves.size() == 4);
  const auto gaps = square.gaps({{2, 2, 0}});
  REQUIRE(gaps.size() == 8);  // both ends of each side
  for (const CreaseGap& gap : gaps) {
    CHECK(gap.at_corner);
    REQUIRE(gap.places.size() == 1);
    CHECK(gap.places[0].kind() == SurfacePoint::Kind::vertex);
  }
  CHECK(total_length(gaps) == Approx(16));  // the whole sides
}

TEST_CASE("crease gaps: beside a corner without a generator, the rest of the curve counts, too") {
  const Square square;
  const auto gaps = square.gaps({{0, 0, 0}, {3, 0, 0}, {4, 4, 0}, {0, 4, 0}, {2, 1, 0}});
  REQUIRE(gaps.size() == 3);
  // The side from (0, 0) to the corner (4, 0), which ends at (3, 0), and the side from there to (4, 4).
  CHECK((gaps[0].at_corner && gaps[1].at_corner));
  CHECK(std::min(gaps[0].length, gaps[1].length) == Approx(1));
  CHECK(std::max(gaps[0].length, gaps[1].length) == Approx(4));
  // Points of the first side as far from (2, 1) as from (0, 0) and as from (3, 0): x = 5 / 4 and 2.
  CHECK_FALSE(gaps[2].at_corner);
  CHECK(gaps[2].length == Approx(0.75));
  CHECK(gaps[2].waits);
  CHECK_FALSE((gaps[0].waits || gaps[1].waits));
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
  REQUIRE(gaps[0].places.size() == 1);
  CHECK((position(square.mesh, gaps[0].places[0]) - Vec3(2, 0, 0)).norm() < 1e-9);
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
  const auto gaps = CreaseGaps(sector, curves, compute_diagram(sector, generators), kWide).find();
  REQUIRE(gaps.size() == 1);
  REQUIRE(gaps[0].places.size() == 1);
  CHECK(position(sector, gaps[0].places[0]).norm() == Approx(0.5));
}

TEST_CASE("crease gaps: a closed curve takes thirds until it has three generators, and counts once") {
  const Mesh can = test::make_can(24, 3);
  const auto curves = trace_creases(can, find_creases(can, {40}));
  REQUIRE(curves.size() == 2);
  REQUIRE(curves[0].closed);
  std::vector<SurfacePoint> generators{vertex_point(can, VertexId(48))};  // in the middle of a cap
  const double length = 24 * 2 * std::sin(std::numbers::pi / 24);
  for (const std::size_t places : {3u, 2u, 2u}) {
    const auto gaps = CreaseGaps(can, {curves[0]}, compute_diagram(can, generators), kWide).find();
    REQUIRE(gaps.size() == 1);
    CHECK(gaps[0].places.size() == places);
    CHECK(gaps[0].length == Approx(length));
    generators.push_back(vertex_point(can, curves[0].vertices[generators.size() - 1]));
  }
}

TEST_CASE("crease gaps: the middle of a bend of more than 40 degrees, where the edge is longer than the spacing") {
  const Mesh can = test::make_can(24, 3);
  const std::vector<CreaseCurve> circle{trace_creases(can, find_creases(can, {40})).front()};
  const auto find = [&](std::size_t step, double spacing) {
    std::vector<SurfacePoint> generators{vertex_point(can, VertexId(49))};  // in the middle of the other cap
    for (std::size_t i = 0; i < 24; i += step) generators.push_back(vertex_point(can, circle[0].vertices[i]));
    return CreaseGaps(can, circle, compute_diagram(can, generators), spacing).find();
  };
  const auto gaps = find(4, 0.9);  // edges of length 1
  REQUIRE(gaps.size() == 6);
  for (const CreaseGap& gap : gaps) {
    CHECK(gap.length == 0);
    REQUIRE(gap.places.size() == 1);
    CHECK(position(can, gap.places[0]).head<2>().norm() == Approx(1));  // at a vertex of the circle
  }
  CHECK(find(4, 1.1).empty());
  CHECK(find(2, 0).empty());  // 30 degrees
}

TEST_CASE("crease gaps: bends of a boundary do not count") {
  const Mesh sector = test::make_sector(20, 4.5);
  const auto edges = find_creases(sector, {180, true});
  const auto corners = place_on_creases(sector, edges, 10).points;
  CHECK(CreaseGaps(sector, trace_creases(sector, edges), compute_diagram(sector, corners), 0).find().empty());
}

TEST_CASE("crease gaps: their lengths are within those of the curves, with any generators") {
  for (const auto& [name, mesh] : test::creased_meshes()) {
    const auto curves = trace_creases(mesh, find_creases(mesh, {40, true}));
    const double length = CreaseFollower(mesh, curves, 0, kWide).length();
    for (const int count : {1, 2, 3, 5, 9, 40}) {
      INFO(name << ", " << count << " generators");
      const Diagram diagram = compute_diagram(mesh, test::random_generators(mesh, count, 7));
      const auto gaps = CreaseGaps(mesh, curves, diagram, kWide).find();
      for (const CreaseGap& gap : gaps) CHECK(gap.length >= 0);
      CHECK(total_length(gaps) <= length * (1 + 1e-12));
      CreaseFollower follower(mesh, curves, 100, kWide);
      CHECK(follower.propose(diagram, 0).empty());
      CHECK(follower.gap_length() <= length);
      CHECK(follower.gap_length() > 0);  // random points are on no corner
    }
  }
}

}  // namespace gvd::test_crease_gaps
