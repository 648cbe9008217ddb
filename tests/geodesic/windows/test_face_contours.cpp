// Curves of equal distance inside coarse faces: corners, joins, curves that cross no edge, and none missed.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/plane.hpp"
#include "gvd/exact_field.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/isoline_pieces.hpp"
#include "support/meshes.hpp"
#include "support/random.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_face_contours {

using test::length_of;
constexpr double kTolerance = test::kIsolineTolerance;

/// 3 x 1, two faces.
Mesh make_rectangle() { return test::make_mesh({{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}); }

/// The largest difference of a piece's points from the level, mean edges.
double worst_of(const Mesh& mesh, const ExactField& field, const std::vector<Isoline>& lines) {
  return test::worst_of(mesh, lines, [&](const SurfacePoint& p) { return field.nearest(p).distance; });
}
int count_misses(const Mesh& mesh, const ExactField& field, double level, const std::vector<Isoline>& lines,
                 int segments) {
  return test::count_misses(mesh, level, lines, segments,
                            [&](const SurfacePoint& p) { return field.nearest(p).distance; });
}

void check_levels(const Mesh& mesh, const ExactField& field, int levels) {
  double largest = 0;
  for (const VertexId v : mesh.vertices()) {
    if (std::isfinite(field.distance(v))) largest = std::max(largest, field.distance(v));
  }
  for (int i = 1; i <= levels; ++i) {
    const double level = largest * (i - 0.37) / levels;
    CAPTURE(level);
    const auto lines = field.isolines({level});
    CHECK(worst_of(mesh, field, lines) <= kTolerance);
    CHECK(count_misses(mesh, field, level, lines, 300) == 0);
    for (const Isoline& line : lines) {
      if (line.closed) continue;
      CHECK(is_on_boundary(mesh, line.points.front()));
      CHECK(is_on_boundary(mesh, line.points.back()));
    }
  }
}

TEST_CASE("an isoline of two sources in a coarse face follows the arcs round both, and no side") {
  const Mesh mesh = make_rectangle();
  const auto at = [](FaceId f, double x, double y) {
    // Face 0 has the corners (0, 0), (3, 0), (3, 1).
    return make_surface_point(f, {1 - x / 3, x / 3 - y, y});
  };
  const ExactField field(mesh, {at(FaceId(0), 2.556, 0.337), at(FaceId(0), 0.889, 0.259)});
  for (const double level : {0.394, 0.788, 0.2, 0.9, 1.0}) {
    CAPTURE(level);
    const auto lines = field.isolines({level});
    CHECK(worst_of(mesh, field, lines) <= kTolerance);
    CHECK(count_misses(mesh, field, level, lines, 1000) == 0);
  }
}

TEST_CASE("an offset curve of a rectangle's boundary has its corners") {
  const Mesh mesh = make_rectangle();
  const ExactField field(mesh, boundary_curves(mesh));
  for (const double level : {0.1, 0.25, 0.4, 0.49}) {
    const auto lines = field.isolines({level});
    REQUIRE(lines.size() == 1);
    CHECK(lines[0].closed);
    CHECK(length_of(mesh, lines[0]) == Approx(2 * (3 - 2 * level) + 2 * (1 - 2 * level)).epsilon(1e-12));
    CHECK(worst_of(mesh, field, lines) <= 1e-9);
  }
  CHECK(field.isolines({0.51}).empty());
}

TEST_CASE("an isoline that closes inside one face is found") {
  const Mesh mesh = test::make_triangle();
  const double perimeter = 2 + std::sqrt(4.5) + std::sqrt(2.5), radius = 3 / perimeter;
  const ExactField offsets(mesh, boundary_curves(mesh));
  for (const double share : {0.01, 0.5, 0.9, 0.99, 0.999}) {
    CAPTURE(share);
    const auto lines = offsets.isolines({share * radius});
    REQUIRE(lines.size() == 1);
    CHECK(lines[0].closed);
    // A chord may cut a corner by the tolerance.
    CHECK(length_of(mesh, lines[0]) ==
          Approx(perimeter * (1 - share)).margin(10 * kTolerance * mesh.mean_edge_length()));
    CHECK(worst_of(mesh, offsets, lines) <= kTolerance);
  }
  // Round the point that is farthest from all three corners: where the circles of the corners leave a gap.
  std::vector<SurfacePoint> corners;
  for (const VertexId v : mesh.vertices()) corners.push_back(vertex_point(mesh, v));
  const ExactField field(mesh, corners);
  const double farthest = 2 * std::sqrt(4.5) * std::sqrt(2.5) / 6;
  for (const double share : {0.99, 0.999}) {
    const auto lines = field.isolines({share * farthest});
    REQUIRE(lines.size() == 1);
    CHECK(lines[0].closed);
    CHECK(worst_of(mesh, field, lines) <= kTolerance);
  }
  CHECK(field.isolines({1.001 * farthest}).empty());
}

TEST_CASE("an isoline through vertices and along edges is still on its level") {
  const Mesh grid = test::make_grid(6, 4);
  const ExactField offsets(grid, boundary_curves(grid));
  const auto one = offsets.isolines({1});
  CHECK(worst_of(grid, offsets, one) <= 1e-9);
  double length = 0;
  for (const Isoline& line : one) length += length_of(grid, line);
  CHECK(length == Approx(12));
  const ExactField field(grid, {vertex_point(grid, VertexId(10)), vertex_point(grid, VertexId(24))});
  for (const double level : {1.0, std::sqrt(2.0), 2.0, 3.0})
    CHECK(worst_of(grid, field, field.isolines({level})) <= kTolerance);
}

TEST_CASE("an isoline that comes back beside itself, nearer than the tolerance, is whole") {
  // Two faces, 100 x 1: the tolerance is 6e-3, and halfway between the long sides the distance is 0.5.
  const Mesh mesh = test::make_mesh({{0, 0, 0}, {100, 0, 0}, {100, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  const ExactField field(mesh, boundary_curves(mesh));
  for (const double below : {1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-9}) {
    CAPTURE(below);
    const double level = 0.5 - below;
    const auto lines = field.isolines({level});
    REQUIRE(lines.size() == 1);
    CHECK(lines[0].closed);
    // Each of the two ends may be cut off by the tolerance.
    const double margin = 2 * kTolerance * mesh.mean_edge_length();
    CHECK(length_of(mesh, lines[0]) == Approx(2 * (100 - 2 * level) + 4 * below).margin(margin));
  }
  CHECK(field.isolines({0.5 + 1e-9}).empty());
}

TEST_CASE("circles that almost touch are one curve where they overlap, and else two") {
  const Mesh mesh = make_rectangle();
  test::Random random(3);
  int wrong = 0;
  for (int i = 0; i < 200; ++i) {
    const Vec2 middle(random.real(0.7, 2.3), random.real(0.35, 0.65));
    const Vec2 arm = 0.3 * unit_vector(random.real(0, 6));
    const auto at = [&](const Vec2& p) {
      const double x = p.x(), y = p.y();  // the diagonal is y = x / 3
      return y < x / 3 ? make_surface_point(FaceId(0), {1 - x / 3, x / 3 - y, y})
                       : make_surface_point(FaceId(1), {1 - y, x / 3, y - x / 3});
    };
    const ExactField field(mesh, {at(middle - arm), at(middle + arm)});
    for (const double beyond : {1e-3, 1e-5, 1e-7, 1e-9, 1e-11}) {
      for (const double level : {0.3 - beyond, 0.3 + beyond}) {
        const auto lines = field.isolines({level});
        const bool reaches_side = std::min({middle.y(), 1 - middle.y()}) - std::abs(arm.y()) < level;
        if (reaches_side) continue;
        wrong += lines.size() != (level < 0.3 ? 2 : 1);
        double length = 0;
        for (const Isoline& line : lines) length += length_of(mesh, line);
        const double half_angle = level < 0.3 ? 0 : std::acos(0.3 / level);
        wrong += std::abs(length - 4 * level * (std::numbers::pi - half_angle)) > 1e-3;
      }
    }
  }
  CHECK(wrong == 0);
}

TEST_CASE("isolines of points are on their level and separate what is nearer from what is farther") {
  for (const auto& [name, mesh] : test::small_family()) {
    CAPTURE(name);
    for (const int count : {1, 4}) check_levels(mesh, ExactField(mesh, test::random_generators(mesh, count, 3)), 5);
  }
}

TEST_CASE("isolines of curves are on their level and separate what is nearer from what is farther") {
  for (const auto& [name, mesh] : test::small_family()) {
    CAPTURE(name);
    std::vector<GeneratorCurve> curves = boundary_curves(mesh);
    if (curves.empty()) {
      const FaceId f(mesh.face_count() / 2);
      curves.push_back(make_polyline({make_surface_point(f, {0.6, 0.3, 0.1}), make_surface_point(f, {0.2, 0.2, 0.6}),
                                      make_surface_point(f, {0.1, 0.7, 0.2})},
                                     false));
    }
    check_levels(mesh, ExactField(mesh, curves), 4);
  }
}

}  // namespace gvd::test_face_contours
