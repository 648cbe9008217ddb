// Where a dual leaves creases and boundaries, and the edges of a remesh along them.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "crease_defects.hpp"
#include "crease_generators.hpp"
#include "gvd/remesh.hpp"
#include "remesh/crease_meshes.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/sanitized.hpp"

namespace gvd::test_crease_defects {

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
  std::vector<CreaseDefect> defects(const std::vector<Vec3>& generators) const {
    std::vector<SurfacePoint> points;
    for (const Vec3& p : generators) points.push_back(vertex_point(mesh, at(p.x(), p.y())));
    return find_crease_defects(mesh, curves, compute_diagram(mesh, points), kWide);
  }
};

double total_length(const std::vector<CreaseDefect>& defects) {
  double sum = 0;
  for (const CreaseDefect& defect : defects) sum += defect.length;
  return sum;
}

TEST_CASE("crease defects: corners without a generator come first") {
  const Square square;
  REQUIRE(square.curves.size() == 4);
  const auto defects = square.defects({{2, 2, 0}});
  REQUIRE(defects.size() == 8);  // both ends of each side
  for (const CreaseDefect& defect : defects) {
    CHECK(defect.at_corner);
    REQUIRE(defect.places.size() == 1);
    CHECK(defect.places[0].kind() == SurfacePoint::Kind::vertex);
  }
  CHECK(total_length(defects) == Approx(16));  // the whole sides
}

TEST_CASE("crease defects: beside a corner without a generator, the rest of the curve counts, too") {
  const Square square;
  const auto defects = square.defects({{0, 0, 0}, {3, 0, 0}, {4, 4, 0}, {0, 4, 0}, {2, 1, 0}});
  REQUIRE(defects.size() == 3);
  // The side from (0, 0) to the corner (4, 0), which ends at (3, 0), and the side from there to (4, 4).
  CHECK((defects[0].at_corner && defects[1].at_corner));
  CHECK(std::min(defects[0].length, defects[1].length) == Approx(1));
  CHECK(std::max(defects[0].length, defects[1].length) == Approx(4));
  // Points of the first side as far from (2, 1) as from (0, 0) and as from (3, 0): x = 5 / 4 and 2.
  CHECK_FALSE(defects[2].at_corner);
  CHECK(defects[2].length == Approx(0.75));
  CHECK(defects[2].waits);
  CHECK_FALSE((defects[0].waits || defects[1].waits));
}

TEST_CASE("crease defects: none where each point of a side belongs to the nearest generators on it") {
  const Square square;
  const std::vector<Vec3> corners{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
  CHECK(square.defects(corners).empty());
  std::vector<Vec3> inside = corners;
  inside.emplace_back(2, 2, 0);  // its cell touches each side in a point
  CHECK(square.defects(inside).empty());
}

TEST_CASE("crease defects: the point opposite to a foreign generator, with the length of its cell on the crease") {
  const Square square;
  const auto defects = square.defects({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {2, 1, 0}});
  REQUIRE(defects.size() == 1);
  REQUIRE(defects[0].places.size() == 1);
  CHECK((position(square.mesh, defects[0].places[0]) - Vec3(2, 0, 0)).norm() < 1e-9);
  // Points of the side as far from (2, 1) as from the nearer corner: x = 5 / 4 and 11 / 4.
  CHECK(defects[0].length == Approx(1.5));
}

TEST_CASE("crease defects: next to a corner, a power of two away from it where a crease of the corner is in the way") {
  const Mesh sector = test::make_sector(2, 0.3);
  const auto curves = trace_creases(sector, find_creases(sector, {180, true}));
  std::vector<SurfacePoint> generators = place_on_creases(sector, find_creases(sector, {180, true}), 10).points;
  // On one of the two straight sides, at 0.4.
  for (std::int32_t e = 0; e < sector.edge_count(); ++e) {
    const HalfedgeId h = sector.halfedge(EdgeId(e));
    if (sector.twin(h).valid() || sector.position(sector.from(h)).norm() > 1e-9) continue;
    generators.push_back(edge_point(h, 0.4));
  }
  const auto defects = find_crease_defects(sector, curves, compute_diagram(sector, generators), kWide);
  REQUIRE(defects.size() == 1);
  REQUIRE(defects[0].places.size() == 1);
  CHECK(position(sector, defects[0].places[0]).norm() == Approx(0.5));
}

TEST_CASE("crease defects: a closed curve takes thirds until it has three generators, and counts once") {
  const Mesh can = test::make_can(24, 3);
  const auto curves = trace_creases(can, find_creases(can, {40}));
  REQUIRE(curves.size() == 2);
  REQUIRE(curves[0].closed);
  std::vector<SurfacePoint> generators{vertex_point(can, VertexId(48))};  // in the middle of a cap
  const double length = 24 * 2 * std::sin(std::numbers::pi / 24);
  for (const std::size_t places : {3u, 2u, 2u}) {
    const auto defects = find_crease_defects(can, {curves[0]}, compute_diagram(can, generators), kWide);
    REQUIRE(defects.size() == 1);
    CHECK(defects[0].places.size() == places);
    CHECK(defects[0].length == Approx(length));
    generators.push_back(vertex_point(can, curves[0].vertices[generators.size() - 1]));
  }
}

TEST_CASE("crease defects: the middle of a bend of more than 40 degrees, where the edge is longer than the spacing") {
  const Mesh can = test::make_can(24, 3);
  const std::vector<CreaseCurve> circle{trace_creases(can, find_creases(can, {40})).front()};
  const auto find = [&](std::size_t step, double spacing) {
    std::vector<SurfacePoint> generators{vertex_point(can, VertexId(49))};  // in the middle of the other cap
    for (std::size_t i = 0; i < 24; i += step) generators.push_back(vertex_point(can, circle[0].vertices[i]));
    return find_crease_defects(can, circle, compute_diagram(can, generators), spacing);
  };
  const auto defects = find(4, 0.9);  // edges of length 1
  REQUIRE(defects.size() == 6);
  for (const CreaseDefect& defect : defects) {
    CHECK(defect.length == 0);
    REQUIRE(defect.places.size() == 1);
    CHECK(position(can, defect.places[0]).head<2>().norm() == Approx(1));  // at a vertex of the circle
  }
  CHECK(find(4, 1.1).empty());
  CHECK(find(2, 0).empty());  // 30 degrees
}

TEST_CASE("crease defects: bends of a boundary do not count") {
  const Mesh sector = test::make_sector(20, 4.5);
  const auto edges = find_creases(sector, {180, true});
  const auto corners = place_on_creases(sector, edges, 10).points;
  CHECK(find_crease_defects(sector, trace_creases(sector, edges), compute_diagram(sector, corners), 0).empty());
}

TEST_CASE("crease defects: their lengths are within those of the curves, with any generators") {
  for (const auto& [name, mesh] : test::creased_meshes()) {
    const auto curves = trace_creases(mesh, find_creases(mesh, {40, true}));
    const double length = CreaseFollower(mesh, curves, 0, kWide).length();
    for (const int count : {1, 2, 3, 5, 9, 40}) {
      INFO(name << ", " << count << " generators");
      const Diagram diagram = compute_diagram(mesh, test::random_generators(mesh, count, 7));
      const auto defects = find_crease_defects(mesh, curves, diagram, kWide);
      for (const CreaseDefect& defect : defects) CHECK(defect.length >= 0);
      CHECK(total_length(defects) <= length * (1 + 1e-12));
      CreaseFollower follower(mesh, curves, 100, kWide);
      CHECK(follower.propose(diagram, 0).empty());
      CHECK(follower.gap_length() <= length);
      CHECK(follower.gap_length() > 0);  // random points are on no corner
    }
  }
}

std::vector<CreaseCurve> curves_of(const Mesh& mesh) { return trace_creases(mesh, find_creases(mesh, {40, true})); }

/// Every chain of a crease is a chain of edges, and its corners are vertices.
void require_followed(const Mesh& mesh, const std::vector<CreaseCurve>& curves, const RemeshResult& result) {
  for (const CreaseCurve& curve : curves) {
    const std::vector<std::size_t> along = test::generators_along(mesh, curve, result.generators);
    const bool is_loop = curve.vertices.front() == curve.vertices.back();
    REQUIRE(along.size() >= (is_loop ? 3u : 2u));
    for (std::size_t k = 1; k < along.size(); ++k) CHECK(test::are_joined(result.mesh, along[k - 1], along[k]));
    if (curve.closed) CHECK(test::are_joined(result.mesh, along.front(), along.back()));
    if (curve.closed) continue;
    CHECK(position(mesh, result.generators[along.front()]) == mesh.position(curve.vertices.front()));
    CHECK(position(mesh, result.generators[along.back()]) == mesh.position(curve.vertices.back()));
  }
}

RemeshResult follow(const Mesh& mesh, const std::vector<SurfacePoint>& generators) {
  RemeshOptions options;
  options.creases = curves_of(mesh);
  return remesh(mesh, generators, options);
}

TEST_CASE("creases: a cube with eight generators is a cube") {
  const Mesh cube = test::make_cube(5);
  const auto creases = find_creases(cube, {40});
  const RemeshResult result = follow(cube, place_on_creases(cube, creases, 10).points);
  CHECK(result.added == 0);
  CHECK(result.mesh.vertex_count() == 8);
  CHECK(result.mesh.face_count() == 12);
  CHECK(result.crease_length == Approx(12));
  CHECK(result.crease_gap_length == 0);
  CHECK(result.input_to_output.hausdorff < 1e-9);
}

TEST_CASE("creases: edges follow them, whatever generators are given") {
  for (const auto& [name, mesh] : test::creased_meshes()) {
    const std::vector<CreaseCurve> curves = curves_of(mesh);
    REQUIRE_FALSE(curves.empty());
    for (const int count : test::thinned({4, 20})) {
      INFO(name << ", " << count << " generators");
      const RemeshResult result = follow(mesh, test::random_generators(mesh, count, 1));
      CHECK(result.crease_gap_length == 0);
      CHECK(result.added_on_creases <= count + 100);
      require_followed(mesh, curves, result);
    }
  }
}

TEST_CASE("creases: without them, edges do not follow") {
  const Mesh cube = test::make_cube(4);
  const RemeshResult result = remesh(cube, test::random_generators(cube, 20, 1));
  CHECK(result.added_on_creases == 0);
  CHECK(result.crease_length == 0);
  const auto curves = curves_of(cube);
  CHECK_FALSE(find_crease_defects(cube, curves, result.diagram, 100).empty());
}

TEST_CASE("creases: no more generators are added than allowed, and what is left is measured") {
  const Mesh cube = test::make_cube(4);
  RemeshOptions options;
  options.creases = curves_of(cube);
  options.max_added = 3;
  const RemeshResult few = remesh(cube, test::random_generators(cube, 40, 1), options);
  CHECK(few.added == 3);
  CHECK(few.crease_gap_length > 0);
  CHECK(few.crease_gap_length < few.crease_length);
  options.refine = false;
  CHECK(remesh(cube, test::random_generators(cube, 40, 1), options).added == 0);
}

TEST_CASE("creases: no more generators are proposed than repairs have left") {
  const Mesh cube = test::make_cube(4);
  const std::vector<CreaseCurve> curves = curves_of(cube);
  std::vector<SurfacePoint> generators = test::random_generators(cube, 40, 1);
  CreaseFollower follower(cube, curves, 7, 100);
  // Whether a larger `may_add` would give more: not where the follower's own limit of 7 is the lower one.
  for (const auto& [may_add, expected, held_back] :
       {std::tuple{2, 2u, true}, {0, 0u, true}, {100, 5u, false}, {100, 0u, false}, {0, 0u, false}}) {
    const auto points = follower.propose(compute_diagram(cube, generators), may_add);
    CHECK(points.size() == expected);
    CHECK(follower.is_held_back() == held_back);
    generators.insert(generators.end(), points.begin(), points.end());
  }
  CHECK(follower.added() == 7);
}

TEST_CASE("creases: a generator too near to a corner does not keep others from the rest of the creases") {
  const Mesh cube = test::make_cube(4);
  const std::vector<CreaseCurve> curves = curves_of(cube);
  std::vector<SurfacePoint> generators = place_on_creases(cube, find_creases(cube, {40}), 0.3).points;
  const SurfacePoint corner = generators.front();
  REQUIRE(corner.kind() == SurfacePoint::Kind::vertex);
  for (double& b : generators.front().bary) b = b == 1 ? 1 - 2e-7 : 1e-7;
  for (const SurfacePoint& p : test::random_generators(cube, 200, 1)) {
    if (p.kind() == SurfacePoint::Kind::face) generators.push_back(p);
  }
  CreaseFollower follower(cube, curves, 1000, 100);
  std::size_t at_curves_of_corner = 0;
  while (true) {
    const auto points = follower.propose(compute_diagram(cube, generators), 1000);
    if (points.empty()) break;
    for (const SurfacePoint& p : points) {
      const Vec3 way = (position(cube, p) - position(cube, corner)).cwiseAbs();
      CHECK(way.norm() > 1e-3);
      at_curves_of_corner += way.sum() < way.maxCoeff() + 1e-9;
    }
    generators.insert(generators.end(), points.begin(), points.end());
  }
  CHECK(at_curves_of_corner > 0);
  CHECK(follower.gap_length() == Approx(1));  // beside the corner, a third of each of its three curves
}

TEST_CASE("creases: two that leave a corner at an acute angle take few generators") {
  const Mesh sector = test::make_sector(3, 0.2);
  std::vector<SurfacePoint> generators = test::random_generators(sector, 6, 3);
  const RemeshResult result = follow(sector, generators);
  CHECK(result.crease_gap_length == 0);
  CHECK(result.rounds <= 8);
  CHECK(result.mesh.vertex_count() <= 40);
}

}  // namespace gvd::test_crease_defects
