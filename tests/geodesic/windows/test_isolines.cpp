// Curves of equal distance: on the level at each point, closed unless they end on the boundary, and none missed.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "gvd/error.hpp"
#include "gvd/exact_field.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/many_threads.hpp"
#include "support/meshes.hpp"
#include "support/refusal.hpp"

namespace gvd::test_isolines {

std::vector<double> make_levels(double step, double largest) {
  std::vector<double> levels;
  for (int i = 1; i * step <= largest; ++i) levels.push_back(i * step);
  return levels;
}

double largest_distance(const Mesh& mesh, const ExactField& field) {
  double largest = 0;
  for (const VertexId v : mesh.vertices()) {
    if (std::isfinite(field.distance(v))) largest = std::max(largest, field.distance(v));
  }
  return largest;
}

double length_of(const Mesh& mesh, const Isoline& line) {
  double length = 0;
  for (std::size_t i = line.closed ? 0 : 1; i < line.points.size(); ++i) {
    const SurfacePoint& before = line.points[(i + line.points.size() - 1) % line.points.size()];
    length += (position(mesh, line.points[i]) - position(mesh, before)).norm();
  }
  return length;
}

/// The points are on the level, neighbours share a face, and only the boundary ends a curve. Returns the largest
/// difference from the level, relative to it.
double check_line(const Mesh& mesh, const ExactField& field, const Isoline& line) {
  double worst = 0;
  const std::size_t n = line.points.size();
  REQUIRE(n >= (line.closed ? 3u : 2u));
  for (std::size_t i = 0; i < n; ++i) {
    worst = std::max(worst, std::abs(field.nearest(line.points[i]).distance - line.level) / line.level);
    if (i + 1 < n || line.closed) CHECK(find_common_view(mesh, line.points[i], line.points[(i + 1) % n]));
  }
  if (!line.closed) {
    CHECK(is_on_boundary(mesh, line.points.front()));
    CHECK(is_on_boundary(mesh, line.points.back()));
  }
  return worst;
}

/// The edges on which curves have points, by level.
std::set<std::pair<double, EdgeId>> crossed_edges(const Mesh& mesh, const std::vector<Isoline>& lines) {
  std::set<std::pair<double, EdgeId>> crossed;
  for (const Isoline& line : lines) {
    for (const SurfacePoint& p : line.points) {
      if (p.kind() == SurfacePoint::Kind::edge) crossed.emplace(line.level, mesh.edge(halfedge(p)));
    }
  }
  return crossed;
}

TEST_CASE("isolines on a plane are circles") {
  const Mesh mesh = test::make_grid(20, 20);
  const SurfacePoint centre = make_surface_point(FaceId(2 * (10 * 20 + 10)), {0.5, 0.3, 0.2});
  const Vec3 at = position(mesh, centre);
  const ExactField field(mesh, {centre});
  for (const double tolerance : {1e-2, 1e-5}) {
    const auto lines = field.isolines({0.05, 0.7, 2.5, 8}, {.chord_tolerance = tolerance});
    REQUIRE(lines.size() == 4);
    for (const Isoline& line : lines) {
      CAPTURE(tolerance, line.level);
      CHECK(line.closed);
      for (const SurfacePoint& p : line.points)
        CHECK((position(mesh, p) - at).norm() == Approx(line.level).epsilon(1e-12));
      const double circle = 2 * std::numbers::pi * line.level, length = length_of(mesh, line);
      CHECK(length < circle);
      // A piece of sagitta s is shorter than its arc by 8 s^2 / (3 chord) or less: relative to the radius, s is all
      // that counts.
      CHECK(length > circle * (1 - 2 * tolerance * mesh.mean_edge_length() / line.level));
    }
  }
}

TEST_CASE("isolines are on their levels, close or end on the boundary, and cross every edge between") {
  for (const auto& [name, mesh] : test::small_family()) {
    CAPTURE(name);
    const auto generators = test::random_generators(mesh, 3, 7);
    const ExactField field(mesh, generators);
    const double largest = largest_distance(mesh, field);
    const auto levels = make_levels(largest / 12.3, largest);
    const auto lines = field.isolines(levels);
    REQUIRE(lines.size() >= levels.size());
    double worst = 0;
    for (const Isoline& line : lines) worst = std::max(worst, check_line(mesh, field, line));
    CHECK(worst < 1e-11);
    const auto crossed = crossed_edges(mesh, lines);
    std::size_t missed = 0, between = 0;
    for (const EdgeId e : mesh.edges()) {
      const double a = field.distance(mesh.from(mesh.halfedge(e))), b = field.distance(mesh.to(mesh.halfedge(e)));
      for (const double level : levels) {
        if ((a < level) == (b < level) || std::min(std::abs(a - level), std::abs(b - level)) < 1e-9 * level) continue;
        // Edges that a generator splits have their points on two faces of the working mesh; all views are on the edge.
        ++between;
        missed += !crossed.contains({level, e});
      }
    }
    CHECK(between > 100);
    CHECK(missed == 0);
  }
}

TEST_CASE("the nearer side of an isoline is on its left") {
  const Mesh mesh = test::make_grid(8, 8);
  const ExactField field(mesh, {vertex_point(mesh, VertexId(40))});
  const Vec3& centre = mesh.position(VertexId(40));
  for (const Isoline& line : field.isolines({0.4, 1.3, 3.1})) {
    double area = 0;
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      const Vec3 a = position(mesh, line.points[i]) - centre;
      const Vec3 b = position(mesh, line.points[(i + 1) % line.points.size()]) - centre;
      area += 0.5 * (a.x() * b.y() - a.y() * b.x());
    }
    CHECK(area == Approx(std::numbers::pi * line.level * line.level).epsilon(0.01));
  }
}

TEST_CASE("isolines through vertices, and of many generators that meet, keep their ends paired") {
  const Mesh mesh = test::make_grid(12, 12);
  std::vector<SurfacePoint> generators;
  for (const int v : {28, 34, 40, 80, 97, 140}) generators.push_back(vertex_point(mesh, VertexId(v)));
  const ExactField field(mesh, generators);
  // Whole distances: levels pass through vertices, and touch where two generators meet.
  for (const auto& levels : {std::vector<double>{1, 2, 3, 4}, {0.5, 1.5, 2.5, 3}, {std::sqrt(2.0), std::sqrt(8.0)}}) {
    const auto lines = field.isolines(levels);
    REQUIRE(lines.size() >= levels.size());
    for (const Isoline& line : lines) CHECK(check_line(mesh, field, line) < 1e-11);
  }
}

TEST_CASE("isolines have no two points in a row in one place, where distances of half a side meet on edges") {
  const Mesh mesh = test::make_grid(4, 4);
  for (const int other : {0, 4, 12, 24}) {
    for (int v = 0; v < mesh.vertex_count(); ++v) {
      if (v == other) continue;
      CAPTURE(other, v);
      const ExactField field(mesh, {vertex_point(mesh, VertexId(other)), vertex_point(mesh, VertexId(v))});
      for (const Isoline& line : field.isolines(make_levels(0.5, largest_distance(mesh, field)))) {
        check_line(mesh, field, line);
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = line.closed ? 0 : 1; i < line.points.size(); ++i) {
          const SurfacePoint& before = line.points[(i + line.points.size() - 1) % line.points.size()];
          least = std::min(least, (position(mesh, line.points[i]) - position(mesh, before)).norm());
        }
        CHECK(least > 1e-12 * line.level);
      }
    }
  }
}

TEST_CASE("isolines up to the largest distance of a bounded field are those of the whole field") {
  const Mesh mesh = test::make_bumpy_sphere(4, 3);
  const auto generators = test::random_generators(mesh, 4, 9);
  const ExactField all(mesh, generators);
  const double limit = 0.4 * largest_distance(mesh, all);
  const ExactField near(mesh, generators, {.max_distance = limit});
  const auto lines = all.isolines({limit / 2, limit}), same = near.isolines({limit / 2, limit});
  REQUIRE(lines.size() == same.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    CHECK(same[i].closed);
    CHECK(length_of(mesh, same[i]) == Approx(length_of(mesh, lines[i])).epsilon(1e-9));
  }
}

TEST_CASE("isolines do not depend on the number of threads") {
  const Mesh mesh = test::make_bumpy_sphere(5, 2);
  const ExactField field(mesh, test::random_generators(mesh, 5, 4));
  const auto levels = make_levels(0.03, largest_distance(mesh, field));
  const auto one = field.isolines(levels, {.threads = 1});
  test::with_many_threads([&] {
    for (const int threads : {0, 2, 7}) {
      const auto lines = field.isolines(levels, {.threads = threads});
      REQUIRE(lines.size() == one.size());
      for (std::size_t i = 0; i < lines.size(); ++i) {
        CHECK(lines[i].level == one[i].level);
        CHECK(lines[i].points == one[i].points);
      }
    }
  });
}

TEST_CASE("isolines of levels that are not ascending, not above 0 or beyond the largest distance are refused") {
  const Mesh mesh = test::make_sphere(2);
  const ExactField field(mesh, {vertex_point(mesh, VertexId(0))}, {.max_distance = 1});
  CHECK(field.isolines({}).empty());
  CHECK(field.isolines({1}).size() == 1);
  for (const std::vector<double>& levels : {std::vector<double>{0}, {0.5, 0.5}, {0.5, 0.2}, {1.01}, {NAN}}) {
    CHECK_THROWS_AS(field.isolines(levels), Error);
  }
  CHECK_THROWS_AS(field.isolines({0.5}, {.chord_tolerance = 0}), Error);
}

TEST_CASE("isolines that would fill the memory are refused before they are traced") {
  const Mesh mesh = test::make_grid(100, 100);  // 30,200 edges
  const ExactField field(mesh, {vertex_point(mesh, VertexId(0))});
  CHECK(test::refusal([&] { field.isolines(make_levels(100 * std::sqrt(2.0) / 200'000, 140)); },
                      ErrorCode::invalid_option) ==
        "the curves would cross edges 3.7e+07 times, more than 2e+07; give fewer levels");
}

}  // namespace gvd::test_isolines
