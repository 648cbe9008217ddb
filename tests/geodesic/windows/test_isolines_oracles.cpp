// Isolines beside distances that are known without the library: round holes of a plane, from the creases of a cube and
// from polylines in the plane.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "base/plane.hpp"
#include "gvd/exact_field.hpp"
#include "gvd/generator_curve.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/isoline_pieces.hpp"
#include "support/meshes.hpp"
#include "support/plane_with_holes.hpp"
#include "support/random.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_isolines_oracles {

constexpr int kSegments = 300;

/// n x n squares of this size, without those whose middle is in a box.
Mesh make_squares(int n, double size, const std::vector<Box2>& holes) {
  std::vector<Vec3> positions;
  std::vector<std::array<int, 3>> faces;
  std::map<std::pair<int, int>, int> number;
  const auto vertex = [&](int x, int y) {
    const auto [at, is_new] = number.emplace(std::pair(x, y), int(positions.size()));
    if (is_new) positions.push_back({x * size, y * size, 0});
    return at->second;
  };
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      const Vec2 middle((x + 0.5) * size, (y + 0.5) * size);
      if (std::ranges::any_of(holes, [&](const Box2& hole) { return hole.contains(middle); })) continue;
      const std::array<int, 4> at{vertex(x, y), vertex(x + 1, y), vertex(x + 1, y + 1), vertex(x, y + 1)};
      faces.push_back({at[0], at[1], at[2]});
      faces.push_back({at[0], at[2], at[3]});
    }
  }
  return test::make_mesh(std::move(positions), faces);
}

Vec2 in_plane(const Mesh& mesh, const SurfacePoint& p) { return position(mesh, p).head<2>(); }

/// Checks levels beside a distance of points of space.
template <class Distance>
void check_levels(const Mesh& mesh, const ExactField& field, const std::vector<double>& levels,
                  const Distance& distance) {
  const auto of_point = [&](const SurfacePoint& p) { return distance(position(mesh, p)); };
  for (const double level : levels) {
    CAPTURE(level);
    const auto lines = field.isolines({level});
    CHECK(test::worst_of(mesh, lines, of_point) <= test::kIsolineTolerance);
    CHECK(test::count_misses(mesh, level, lines, kSegments, of_point) == 0);
    for (const Isoline& line : lines) {
      if (line.closed) continue;
      CHECK(is_on_boundary(mesh, line.points.front()));
      CHECK(is_on_boundary(mesh, line.points.back()));
    }
  }
}

TEST_CASE("isolines round the holes of a plane bend at the corners of the holes, as the visibility graph does") {
  const Box2 notch(Vec2(3, 3), Vec2(6, 6)), hole(Vec2(1, 1), Vec2(2, 2));  // an L with a hole
  for (const auto& [n, size] : {std::pair(6, 1.0), std::pair(12, 0.5)}) {
    const Mesh mesh = make_squares(n, size, {notch, hole});
    for (const std::uint32_t seed : {1u, 2u, 3u}) {
      const auto sources = test::random_generators(mesh, int(seed), seed);
      std::vector<Vec2> at;
      for (const SurfacePoint& p : sources) at.push_back(in_plane(mesh, p));
      const test::PlaneWithHoles plane({notch, hole}, at);
      check_levels(mesh, ExactField(mesh, sources), {0.21, 0.8, 1.3, 2.2, 3.1, 4.05, 5.5},
                   [&](const Vec3& p) { return plane.distance(p.head<2>()); });
    }
  }
}

/// The unit cube with n x n squares a side.
Mesh make_cube(int n) {
  std::vector<Vec3> positions;
  std::vector<std::array<int, 3>> faces;
  std::map<std::array<int, 3>, int> number;
  for (int axis = 0; axis < 3; ++axis) {
    for (const int depth : {0, n}) {
      const auto vertex = [&](int u, int v) {
        std::array<int, 3> at{};
        at[axis] = depth;
        at[(axis + 1) % 3] = u;
        at[(axis + 2) % 3] = v;
        const auto [found, is_new] = number.emplace(at, int(positions.size()));
        if (is_new) positions.push_back(Vec3(at[0], at[1], at[2]) / n);
        return found->second;
      };
      for (int u = 0; u < n; ++u) {
        for (int v = 0; v < n; ++v) {
          const int a = vertex(u, v), b = vertex(u + 1, v), c = vertex(u + 1, v + 1), d = vertex(u, v + 1);
          faces.push_back(depth > 0 ? std::array{a, b, c} : std::array{a, c, b});
          faces.push_back(depth > 0 ? std::array{a, c, d} : std::array{a, d, c});
        }
      }
    }
  }
  return test::make_mesh(std::move(positions), faces);
}

TEST_CASE("isolines from the creases of a cube are squares on its sides") {
  for (const int n : {1, 2, 5}) {
    CAPTURE(n);
    const Mesh mesh = make_cube(n);
    const ExactField field(mesh, crease_curves(mesh, 57.3));
    const auto distance = [](const Vec3& p) {
      std::array<double, 3> to_side{};
      for (int i = 0; i < 3; ++i) to_side[i] = std::min(p[i], 1 - p[i]);
      std::ranges::sort(to_side);  // the least one is 0: that of the side that p is on
      return to_side[1];
    };
    const std::vector<double> levels{0.01, 0.1, 0.2, 0.25, 0.4, 0.49, 0.4999};
    check_levels(mesh, field, levels, distance);
    for (const double level : levels) {
      CAPTURE(level);
      const auto lines = field.isolines({level});
      CHECK(lines.size() == 6);
      double length = 0;
      for (const Isoline& line : lines) {
        CHECK(line.closed);
        length += test::length_of(mesh, line);
      }
      CHECK(length == Approx(24 * (1 - 2 * level)).epsilon(1e-9));
    }
    CHECK(field.isolines({0.5 + 1e-9}).empty());
  }
}

TEST_CASE("isolines from polylines in the plane are their offset curves") {
  for (const int n : {1, 3, 9}) {
    const double size = 4.0 / n;
    const Mesh mesh = make_squares(n, size, {});
    test::Random random{std::uint32_t(n)};
    // The face whose lower left square has the point; the diagonal runs upwards.
    const auto on_mesh = [&](const Vec2& p) {
      const int x = std::min(n - 1, int(p.x() / size)), y = std::min(n - 1, int(p.y() / size));
      const Vec2 local = p / size - Vec2(x, y);
      const int square = 2 * (y * n + x);
      return local.y() < local.x()
                 ? make_surface_point(FaceId(square), {1 - local.x(), local.x() - local.y(), local.y()})
                 : make_surface_point(FaceId(square + 1), {1 - local.y(), local.x(), local.y() - local.x()});
    };
    for (int i = 0; i < 8; ++i) {
      // Segments of a polyline lie in one face each: both ends are in the first face.
      std::vector<Vec2> corners;
      const int count = 2 + int(random.below(3));
      for (int k = 0; k < count; ++k) {
        const double x = size * (0.05 + 0.9 * (k + random.real(0, 0.9)) / count);
        corners.push_back({x, x * random.real(0.02, 0.95)});
      }
      std::vector<SurfacePoint> points;
      for (const Vec2& p : corners) points.push_back(on_mesh(p));
      const ExactField field(mesh, std::vector{make_polyline(points, false)});
      const auto distance = [&](const Vec3& p) {
        double least = kInfinity;
        for (std::size_t k = 1; k < corners.size(); ++k) {
          const Vec2 way = corners[k] - corners[k - 1], at = p.head<2>();
          const double t = nearest_on_segment(corners[k - 1], way, at);
          least = std::min(least, (corners[k - 1] + t * way - at).norm());
        }
        return least;
      };
      check_levels(mesh, field, {0.03, 0.3, 1.1, 2.3}, distance);
    }
  }
}

}  // namespace gvd::test_isolines_oracles
