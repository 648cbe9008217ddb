// Curves of equal distance inside coarse faces: corners, joins, curves that cross no edge, and none missed.

#include <cmath>
#include <map>
#include <vector>

#include "base/plane.hpp"
#include "geodesic/face_layout.hpp"
#include "gvd/exact_field.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/random.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_face_contours {

/// The default tolerance of isolines, in mean edges, and rounding.
constexpr double kTolerance = 1e-4 + 1e-9;

/// 3 x 1, two faces.
Mesh make_rectangle() { return test::make_mesh({{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}); }

/// A straight piece of an isoline, in a face that has both ends.
struct Piece {
  SurfacePoint from, to;

  SurfacePoint at(double t) const {
    Bary bary{};
    for (std::size_t i = 0; i < 3; ++i) bary[i] = (1 - t) * from.bary[i] + t * to.bary[i];
    return make_surface_point(from.face, bary);
  }
};

std::vector<Piece> pieces_of(const Mesh& mesh, const Isoline& line) {
  std::vector<Piece> pieces;
  for (std::size_t i = line.closed ? 0 : 1; i < line.points.size(); ++i) {
    const auto shared =
        find_common_view(mesh, line.points[(i + line.points.size() - 1) % line.points.size()], line.points[i]);
    REQUIRE(shared);
    pieces.push_back({shared->first, shared->second});
  }
  return pieces;
}

double length_of(const Mesh& mesh, const Isoline& line) {
  double length = 0;
  for (const Piece& piece : pieces_of(mesh, line))
    length += (position(mesh, piece.to) - position(mesh, piece.from)).norm();
  return length;
}

/// The largest difference of a piece's points from the level, mean edges.
double worst_of(const Mesh& mesh, const ExactField& field, const std::vector<Isoline>& lines) {
  double worst = 0;
  for (const Isoline& line : lines) {
    for (const Piece& piece : pieces_of(mesh, line)) {
      for (const double t : {0.0, 0.25, 0.5, 0.75}) {
        worst = std::max(worst, std::abs(field.nearest(piece.at(t)).distance - line.level));
      }
    }
  }
  return worst / mesh.mean_edge_length();
}

/// Counts random segments inside faces whose ends lie on different sides of a level, while they cross its isolines an
/// even number of times, or the other way round.
int count_misses(const Mesh& mesh, const ExactField& field, double level, const std::vector<Isoline>& lines,
                 int segments) {
  std::map<FaceId, std::vector<PlaneSegment>> in_face;
  for (const Isoline& line : lines) {
    for (const Piece& piece : pieces_of(mesh, line)) {
      const FaceLayout layout(mesh, piece.from.face);
      in_face[piece.from.face].push_back({layout.at(piece.from.bary), layout.at(piece.to.bary)});
    }
  }
  test::Random random(5);
  const auto inside = [&](FaceId f) {
    const double u = random.real(0, 1), v = random.real(0, 1);
    return make_surface_point(f, u + v < 1 ? Bary{u, v, 1 - u - v} : Bary{1 - u, 1 - v, u + v - 1});
  };
  int misses = 0;
  for (int i = 0; i < segments; ++i) {
    const FaceId f(random.below(mesh.face_count()));
    const SurfacePoint a = inside(f), b = inside(f);
    const double from = field.nearest(a).distance - level, to = field.nearest(b).distance - level;
    if (std::min(std::abs(from), std::abs(to)) < 2 * kTolerance * mesh.mean_edge_length()) continue;
    const FaceLayout layout(mesh, f);
    const PlaneSegment segment{layout.at(a.bary), layout.at(b.bary)};
    int crossed = 0;
    for (const PlaneSegment& piece : in_face[f]) {
      crossed += !lie_on_one_side(segment, piece.from, piece.to) && !lie_on_one_side(piece, segment.from, segment.to);
    }
    misses += (crossed % 2 == 1) != ((from > 0) != (to > 0));
  }
  return misses;
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
