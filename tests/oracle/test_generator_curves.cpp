// Curves as generators: distances and diagrams beside the plane, and beside dense points of the curves.

#include <algorithm>
#include <array>
#include <cmath>

#include "geodesic/windows/propagation/join_points.hpp"
#include "gvd/check.hpp"
#include "gvd/diagram.hpp"
#include "gvd/error.hpp"
#include "gvd/exact_field.hpp"
#include "gvd/generator_curve.hpp"
#include "gvd/soup.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/same_diagram.hpp"

namespace gvd::test_generator_curves {

/// The polyline of shortest paths through random points of one component. A closed one may cross itself.
GeneratorCurve random_curve(const Mesh& mesh, int corners, unsigned seed, bool closed = false) {
  const std::vector<SurfacePoint> at = test::random_generators(mesh, corners, seed);
  const VertexDistances reached = compute_vertex_distances(mesh, {at.front()});
  std::vector<SurfacePoint> points{at.front()};
  const auto add_between = [&](const SurfacePoint& next) {
    const std::vector<SurfacePoint> between = join_points(mesh, points.back(), next);
    points.insert(points.end(), between.begin(), between.end());
  };
  for (const SurfacePoint& next : at) {
    if (next == at.front() || std::isinf(reached.distance[mesh.vertices(next.face)[0]])) continue;
    add_between(next);
    points.push_back(next);
  }
  if (closed && points.size() > 1) add_between(at.front());
  return make_polyline(points, closed);
}

/// So many random curves that neither touch nor cross.
std::vector<GeneratorCurve> random_curves(const Mesh& mesh, int count, unsigned seed) {
  std::vector<GeneratorCurve> curves;
  for (unsigned i = 0; int(curves.size()) < count && i < 50; ++i) {
    curves.push_back(random_curve(mesh, 1 + int(i % 4), 100 * seed + i, i % 2 == 1));
    try {
      compute_vertex_distances(mesh, curves);
    } catch (const Error& error) {
      CHECK(error.code() == ErrorCode::precondition);
      curves.pop_back();
    }
  }
  return curves;
}

double length_of(const Mesh& mesh, const std::vector<SurfacePoint>& points) {
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    length += (position(mesh, points[i]) - position(mesh, points[i - 1])).norm();
  }
  return length;
}

double distance_to(const Mesh& mesh, const GeneratorCurve& curve, const Vec3& p) {
  double least = kInfinity;
  for (const auto& [a, b] : curve.segments) {
    const Vec3 from = position(mesh, curve.points[a]), way = position(mesh, curve.points[b]) - from;
    const double t = way.squaredNorm() > 0 ? std::clamp((p - from).dot(way) / way.squaredNorm(), 0.0, 1.0) : 0;
    least = std::min(least, (p - from - t * way).norm());
  }
  return least;
}

/// Points on all segments, at most `spacing` apart.
std::vector<SurfacePoint> dense_points(const Mesh& mesh, const GeneratorCurve& curve, double spacing) {
  std::vector<SurfacePoint> dense = curve.points;
  for (const auto& [a, b] : curve.segments) {
    const auto [from, to] = *find_common_view(mesh, curve.points[a], curve.points[b]);
    const double length = (position(mesh, to) - position(mesh, from)).norm();
    const int pieces = int(std::ceil(length / spacing));
    for (int i = 1; i < pieces; ++i) {
      std::array<double, 3> bary{};
      for (int k = 0; k < 3; ++k) bary[k] = from.bary[k] + double(i) / pieces * (to.bary[k] - from.bary[k]);
      dense.push_back(make_surface_point(from.face, bary));
    }
  }
  std::vector<SurfacePoint> apart;
  const double least = 4 * coincidence(mesh);
  for (const SurfacePoint& p : dense) {
    const Vec3 at = position(mesh, p);
    if (std::ranges::none_of(apart, [&](const SurfacePoint& q) { return (position(mesh, q) - at).norm() <= least; }))
      apart.push_back(p);
  }
  return apart;
}

TEST_CASE("distances from curves on a flat mesh are those of the plane") {
  const Mesh mesh = test::make_grid(9, 7);
  for (const unsigned seed : {1, 2, 3, 4, 5, 6}) {
    CAPTURE(seed);
    const GeneratorCurve curve = random_curve(mesh, 2 + int(seed % 4), seed, seed % 2 == 0);
    const ExactField field(mesh, std::vector{curve});
    for (const VertexId v : mesh.vertices()) {
      CHECK(field.distance(v) == Approx(distance_to(mesh, curve, mesh.position(v))).epsilon(1e-12).margin(1e-13));
    }
    for (const SurfacePoint& p : test::random_generators(mesh, 300, seed + 100)) {
      const double expected = distance_to(mesh, curve, position(mesh, p));
      CHECK(field.nearest(p).distance == Approx(expected).epsilon(1e-12).margin(1e-13));
      const GeodesicPath path = field.path(p);
      CHECK(path.complete);
      CHECK(length_of(mesh, path.points) == Approx(expected).epsilon(1e-11).margin(1e-12));
      CHECK(distance_to(mesh, curve, position(mesh, path.points.back())) < 1e-11);
    }
    for (const Isoline& line : field.isolines({0.2, 0.9, 2.1})) {
      for (const SurfacePoint& p : line.points) {
        CHECK(distance_to(mesh, curve, position(mesh, p)) == Approx(line.level).epsilon(1e-11));
      }
    }
  }
}

TEST_CASE("distances from curves are those from dense points of them, and never longer") {
  for (const auto& [name, mesh] : test::small_family()) {
    CAPTURE(name);
    for (const unsigned seed : {1, 2}) {
      CAPTURE(seed);
      const GeneratorCurve curve = random_curve(mesh, 4, seed, seed == 2);
      const double spacing = 0.02 * mesh.bbox_diagonal();
      const std::vector<SurfacePoint> dense = dense_points(mesh, curve, spacing);
      const VertexDistances exact = compute_vertex_distances(mesh, std::vector{curve});
      const VertexDistances sampled = compute_vertex_distances(mesh, dense);
      const ExactField field(mesh, std::vector{curve});
      for (const VertexId v : mesh.vertices()) {
        const double d = exact.distance[v];
        CHECK(field.distance(v) == d);
        if (std::isinf(sampled.distance[v])) {
          CHECK(std::isinf(d));
          continue;
        }
        CHECK(d <= sampled.distance[v] * (1 + 1e-12) + 1e-13);
        CHECK(d >= sampled.distance[v] - 0.5 * spacing);
        const GeodesicPath path = field.path(vertex_point(mesh, v));
        CHECK(path.complete);
        CHECK(length_of(mesh, path.points) == Approx(d).epsilon(1e-9).margin(1e-10));
      }
    }
  }
}

TEST_CASE("the diagram of curves passes all checks, and its points are as far from both curves") {
  for (const auto& [name, mesh] : test::small_family()) {
    CAPTURE(name);
    for (const unsigned seed : {3, 4}) {
      CAPTURE(seed);
      const std::vector<GeneratorCurve> curves = random_curves(mesh, 5, seed);
      REQUIRE(curves.size() > 1);
      const Diagram diagram = compute_diagram(mesh, curves);
      for (const std::string& problem : check_diagram(mesh, diagram).violations) FAIL_CHECK(problem);
      std::vector<ExactField> fields;
      for (const GeneratorCurve& curve : curves) fields.emplace_back(mesh, std::vector{curve});
      const double near = 1e-6 * mesh.mean_edge_length();  // inner points are found within the chord tolerance
      for (const Bisector& b : diagram.bisectors) {
        for (const SurfacePoint& p : b.points) {
          const double left = fields[b.left.index()].nearest(p).distance;
          const double right = fields[b.right.index()].nearest(p).distance;
          CHECK(std::abs(left - right) <= near);
          for (const ExactField& field : fields) {
            CHECK(field.nearest(p).distance >= left - near);
          }
        }
      }
      for (const VertexId v : mesh.vertices()) {
        const GeneratorId g = diagram.vertex_label[v];
        if (!g.valid()) continue;
        CHECK(diagram.vertex_distance[v] ==
              Approx(fields[g.index()].distance(v)).epsilon(1e-12).margin(1e-12 * mesh.bbox_diagonal()));
      }
      DiagramOptions threads;
      threads.threads = 3;
      CHECK(test::same_diagram(diagram, compute_diagram(mesh, curves, threads)));
    }
  }
}

TEST_CASE("the boundary of a ring is two curves, and their bisector lies halfway up") {
  const Mesh mesh = test::make_ring(24, 5);
  const std::vector<GeneratorCurve> loops = boundary_curves(mesh);
  REQUIRE(loops.size() == 2);
  const Diagram diagram = compute_diagram(mesh, loops);
  CHECK(check_diagram(mesh, diagram).violations.empty());
  REQUIRE(diagram.bisectors.size() == 1);
  CHECK(diagram.bisectors[BisectorId(0)].closed);
  const double height = (mesh.position(VertexId(0)) - mesh.position(VertexId(mesh.vertex_count() - 1))).z();
  for (const SurfacePoint& p : diagram.bisectors[BisectorId(0)].points) {
    CHECK(std::abs(2 * (position(mesh, p).z() - mesh.position(VertexId(0)).z()) + height) < 1e-12);
  }
  for (const Cell& cell : diagram.cells) {
    CHECK(cell.euler_characteristic == 0);
    CHECK(cell.boundary_loops == 2);
    CHECK(cell.area == Approx(0.5 * compute_mesh_summary(mesh).area).epsilon(1e-12));
  }
}

TEST_CASE("distances from the creases of a box are those to the nearest side of each rectangle") {
  const Mesh mesh = test::make_plate(6, 0.5);
  const std::vector<GeneratorCurve> creases = crease_curves(mesh, 30);
  REQUIRE(creases.size() == 1);
  const ExactField field(mesh, creases);
  Vec3 low = mesh.position(VertexId(0)), high = low;
  for (const Vec3& p : mesh.positions()) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  for (const SurfacePoint& point : test::random_generators(mesh, 200, 5)) {
    const Vec3 p = position(mesh, point);
    // On one face of the box a coordinate is that of the face; the others tell the distances from its four sides.
    std::array<double, 3> from_side{};
    for (int i = 0; i < 3; ++i) from_side[i] = std::min(p[i] - low[i], high[i] - p[i]);
    std::sort(from_side.begin(), from_side.end());
    CHECK(field.nearest(point).distance == Approx(from_side[1]).epsilon(1e-12).margin(1e-13));
  }
}

TEST_CASE("a path is as long as the distance from every vertex, also where windows are seen edge on") {
  for (const auto& [name, mesh] : test::small_family()) {
    for (const unsigned seed : {1, 2, 3}) {
      CAPTURE(name, seed);
      const ExactField field(mesh, {vertex_point(mesh, VertexId((97 * seed) % mesh.vertex_count()))});
      for (const VertexId v : mesh.vertices()) {
        if (std::isinf(field.distance(v))) continue;
        const GeodesicPath path = field.path(vertex_point(mesh, v));
        CHECK(path.complete);
        CHECK(length_of(mesh, path.points) == Approx(field.distance(v)).epsilon(1e-10).margin(1e-12));
      }
    }
  }
}

}  // namespace gvd::test_generator_curves
