// Needles and faces without area, where rounding separates what should touch.
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <random>

#include "geodesic/windows/propagation/propagate_windows.hpp"
#include "mesh/working_mesh.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/propagate.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_window_needles {

using test::propagate;

/// A tube of n rings of six vertices, of radius `radius` and length 1.
Mesh make_tube(int rings, double radius) {
  std::vector<Vec3> positions;
  std::vector<std::array<int, 3>> faces;
  for (int j = 0; j <= rings; ++j) {
    for (int i = 0; i < 6; ++i) {
      positions.emplace_back(radius * std::cos(i * M_PI / 3), radius * std::sin(i * M_PI / 3), double(j) / rings);
      if (j == rings) continue;
      const int a = 6 * j + i, b = 6 * j + (i + 1) % 6;
      faces.push_back({a, b, b + 6});
      faces.push_back({a, b + 6, a + 6});
    }
  }
  return test::make_mesh(std::move(positions), faces);
}

/// Two cones over `count` points, all on one line.
Mesh make_line(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Vec3> positions;
  std::vector<std::array<int, 3>> faces;
  for (int i = 0; i < count + 2; ++i) positions.emplace_back((double(random()) + 0.5) / 4294967296.0, 0, 0);
  for (int i = 0; i < count; ++i) {
    const int j = (i + 1) % count;
    faces.push_back({i, j, count});
    faces.push_back({j, i, count + 1});
  }
  return test::make_mesh(std::move(positions), faces);
}

/// Two tips at a distance of 2, and a ring of `sides` vertices of radius `radius` half way between them.
Mesh make_spindle(int sides, double radius) {
  std::vector<Vec3> positions{{0, 0, 1}, {0, 0, -1}};
  std::vector<std::array<int, 3>> faces;
  for (int i = 0; i < sides; ++i) {
    const double angle = i * 2 * M_PI / sides;
    positions.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
    faces.push_back({2 + i, 2 + (i + 1) % sides, 0});
    faces.push_back({2 + (i + 1) % sides, 2 + i, 1});
  }
  return test::make_mesh(std::move(positions), faces);
}

TEST_CASE("windows do not wind round thin tubes for ever, and stay few where all paths tie") {
  const auto carried_a_face = [](const Mesh& mesh) {
    return double(propagate(mesh, {VertexId(1)}).carried) / mesh.face_count();
  };
  for (const double radius : {1e-4, 1e-7, 1e-9, 1e-12, 1e-14}) {
    INFO(radius);
    CHECK(carried_a_face(make_tube(80, radius)) < 60);
  }
  for (const unsigned seed : {1, 2, 3, 4}) {
    INFO(seed);
    CHECK(carried_a_face(make_line(160, seed)) < 160);
  }
  for (const int sides : {3, 4, 8}) {
    for (const double radius : {1e-1, 1e-2, 1e-3, 1e-4, 2e-5, 5e-6, 1e-9}) {
      CAPTURE(sides, radius);
      const Mesh mesh = make_spindle(sides, radius);
      CHECK(double(propagate(mesh, {VertexId(0)}).carried) / mesh.face_count() < 50);
      CHECK(double(propagate(mesh, {VertexId(2)}).carried) / mesh.face_count() < 50);
    }
  }
}

TEST_CASE("paths along vertices that lie on a line up to rounding are found") {
  // A plane with vertices within 1e-10 of a straight line: windows as narrow as that pass between them.
  std::vector<Vec3> positions{{0, 1, 0}, {0, -1, 0}};
  std::vector<std::array<int, 3>> faces;
  std::mt19937 random(4);
  for (int i = 0; i <= 24; ++i) {
    positions.emplace_back(-1 + i / 12.0, 1e-10 * (2 * double(random()) / double(std::mt19937::max()) - 1), 0);
    if (i == 24) break;
    faces.push_back({2 + i, 3 + i, 0});
    faces.push_back({3 + i, 2 + i, 1});
  }
  const Mesh mesh = test::make_mesh(std::move(positions), faces);
  for (int g = 0; g < mesh.vertex_count(); ++g) {
    const WindowField field = propagate(mesh, {VertexId(g)});
    for (int v = 0; v < mesh.vertex_count(); ++v) {
      const double straight = (mesh.position(VertexId(v)) - mesh.position(VertexId(g))).norm();
      CHECK(field.distance[VertexId(v)] == Approx(straight).epsilon(1e-12));
    }
  }
}

TEST_CASE("vertices behind faces without area are reached") {
  // Between (0,0) and (2,0) lies a face that is a line, its third corner at (1,0).
  const auto face = [](int a, int b, int c) { return std::array{VertexId(a), VertexId(b), VertexId(c)}; };
  const Mesh mesh({{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0.7, -1, 0}, {1.2, -1, 0}},
                  {face(0, 1, 3), face(1, 0, 2), face(0, 4, 2), face(2, 4, 5), face(2, 5, 1)});
  for (int g = 0; g < mesh.vertex_count(); ++g) {
    const WindowField field = propagate(mesh, {VertexId(g)});
    for (int v = 0; v < mesh.vertex_count(); ++v) {
      const double straight = (mesh.position(VertexId(v)) - mesh.position(VertexId(g))).norm();
      CHECK(field.distance[VertexId(v)] == Approx(straight).epsilon(1e-11));
    }
  }
}

/// Distances from vertex g along paths over those points of edges that are the nearest to some vertex. They are upper
/// bounds; on a mesh whose vertices lie on one line, they are exact.
std::vector<double> measure_by_graph(const Mesh& mesh, int g) {
  std::vector<Vec3> points = mesh.positions();
  std::vector<std::vector<std::size_t>> on_face(static_cast<std::size_t>(mesh.face_count()));
  for (int f = 0; f < mesh.face_count(); ++f) {
    for (const VertexId v : mesh.vertices(FaceId(f))) on_face[f].push_back(v.index());
  }
  for (int e = 0; e < mesh.edge_count(); ++e) {
    const HalfedgeId h = mesh.halfedge(EdgeId(e));
    const Vec3 from = mesh.position(mesh.from(h)), along = mesh.position(mesh.to(h)) - from;
    for (int v = 0; v < mesh.vertex_count(); ++v) {
      const double t = (mesh.position(VertexId(v)) - from).dot(along) / along.squaredNorm();
      if (!(t > 0 && t < 1)) continue;
      on_face[Mesh::face(h).index()].push_back(points.size());
      if (mesh.twin(h).valid()) on_face[Mesh::face(mesh.twin(h)).index()].push_back(points.size());
      points.push_back(from + t * along);
    }
  }
  std::vector<double> distance(points.size(), std::numeric_limits<double>::infinity());
  distance[g] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& face : on_face) {
      for (const std::size_t a : face) {
        for (const std::size_t b : face) {
          const double d = distance[a] + (points[b] - points[a]).norm();
          if (!(d < distance[b] * (1 - 1e-15))) continue;
          distance[b] = d;
          changed = true;
        }
      }
    }
  }
  return distance;
}

void check_by_graph(const Mesh& mesh) {
  for (int g = 0; g < mesh.vertex_count(); ++g) {
    const std::vector<double> expected = measure_by_graph(mesh, g);
    const WindowField field = propagate(mesh, {VertexId(g)});
    for (int v = 0; v < mesh.vertex_count(); ++v) {
      INFO("from " << g << " to " << v);
      CHECK(field.distance[VertexId(v)] == Approx(expected[v]).margin(1e-11));
    }
  }
}

TEST_CASE("distances between points of one line, over faces without area") {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    INFO("seed " << seed);
    check_by_graph(make_line(3 + int(seed) % 5, seed));
  }
}

TEST_CASE("paths go round a boundary vertex whose corners are folded flat") {
  // The corners at vertex 1 add up to three times pi in the first mesh, and to pi up to rounding in the second one. No
  // path may turn back there, but the vertices beyond must be reached.
  check_by_graph(test::make_mesh({{0.3026, 0, 0}, {0.2936, 0, 0}, {0.3467, 0, 0}, {0, 0, 0}}, {{0, 1, 3}, {1, 2, 3}}));
  std::vector<Vec3> positions;
  for (const double x : {0.4703, 0.3983, 0.0, 1.0, 0.3327, 0.2988, 0.1992, 0.2352, 0.6027, 0.7352, 0.6992}) {
    positions.emplace_back(x, 0, 0);
  }
  check_by_graph(test::make_mesh(
      std::move(positions),
      {{1, 4, 0}, {0, 8, 1}, {4, 5, 0}, {5, 6, 0}, {2, 7, 6}, {7, 0, 6}, {8, 9, 1}, {3, 10, 9}, {10, 1, 9}}));
}

/// The surface of a box, n by n squares a side, `height` thick and turned by an angle with the sine 0.6.
Mesh make_turned_box(int n, double height) {
  std::vector<Vec3> positions;
  std::vector<std::array<int, 3>> faces;
  std::map<std::array<int, 3>, int> ids;
  const auto vertex = [&](const std::array<int, 3>& at) {
    const auto [found, fresh] = ids.try_emplace(at, int(positions.size()));
    const Vec3 p = Vec3(at[0], height * at[1], at[2]) / n;
    if (fresh) positions.emplace_back(0.8 * p.x() - 0.6 * p.y(), 0.6 * p.x() + 0.8 * p.y(), p.z());
    return found->second;
  };
  for (std::size_t side = 0; side < 6; ++side) {
    for (int cell = 0; cell < n * n; ++cell) {
      const auto corner = [&](int i, int j) {
        std::array<int, 3> at{};
        at[side / 2] = side % 2 == 0 ? 0 : n;
        at[(side / 2 + 1) % 3] = cell / n + i;
        at[(side / 2 + 2) % 3] = cell % n + j;
        return vertex(at);
      };
      std::array<int, 4> square{corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
      if (side % 2 == 0) std::swap(square[1], square[3]);
      faces.push_back({square[0], square[1], square[2]});
      faces.push_back({square[0], square[2], square[3]});
    }
  }
  return test::make_mesh(std::move(positions), faces);
}

TEST_CASE("a box that is pressed flat has the distances of one that is nearly flat") {
  const auto make_box = [](double height) {
    // Two by two squares a side.
    std::vector<Vec3> positions;
    std::vector<std::array<int, 3>> faces;
    std::map<std::array<int, 3>, int> ids;
    for (int axis = 0; axis < 3; ++axis) {
      for (int side = 0; side <= 2; side += 2) {
        for (int cell = 0; cell < 4; ++cell) {
          const auto corner = [&](int a, int b) {
            std::array<int, 3> at{};
            at[std::size_t(axis)] = side, at[std::size_t(axis + 1) % 3] = a, at[std::size_t(axis + 2) % 3] = b;
            const auto [found, fresh] = ids.try_emplace(at, int(positions.size()));
            if (fresh) positions.emplace_back(0.5 * at[0] * height, 0.5 * at[1], 0.5 * at[2]);
            return found->second;
          };
          const int i = cell / 2, j = cell % 2;
          int a = corner(i, j), b = corner(i + 1, j), c = corner(i + 1, j + 1), d = corner(i, j + 1);
          if (side == 0) std::swap(b, d);
          faces.push_back({a, b, c});
          faces.push_back({a, c, d});
        }
      }
    }
    return test::make_mesh(std::move(positions), faces);
  };
  const Mesh reference = make_box(1e-6);
  for (const double height : {1e-7, 1e-9, 1e-11, 1e-12, 1e-13, 1e-14, 1e-15}) {
    INFO(height);
    const Mesh box = make_box(height);
    for (int g = 0; g < box.vertex_count(); ++g) {
      const WindowField flat = propagate(box, {VertexId(g)}), thick = propagate(reference, {VertexId(g)});
      for (int v = 0; v < box.vertex_count(); ++v) {
        CHECK(flat.distance[VertexId(v)] == Approx(thick.distance[VertexId(v)]).margin(3e-6));
      }
    }
  }
}

TEST_CASE("paths through the gap that thin faces open behind a vertex") {
  // Flat boxes, turned so that the coordinates of their corners are rounded: distances in both directions agree.
  for (const double height : {1.135e-5, 4.871e-5, 2.4897e-4}) {
    CAPTURE(height);
    const Mesh box = make_turned_box(4, height);
    std::vector<std::vector<double>> distances;
    for (int g = 0; g < box.vertex_count(); ++g) distances.push_back(propagate(box, {VertexId(g)}).distance.raw());
    double worst = 0;
    for (std::size_t a = 0; a < distances.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) worst = std::max(worst, std::abs(distances[a][b] - distances[b][a]));
    }
    CHECK(worst < 1e-12);
  }
}

TEST_CASE("paths round a spindle are found past needles that share a vertex") {
  // Seven points on a small ring, two tips, and a point on each long side: paths between these go round the ring.
  std::vector<Vec3> positions{{0, 0, 1}, {0, 0, -1}};
  std::vector<std::array<int, 3>> faces;
  const double radius = 5e-8;
  for (int i = 0; i < 7; ++i) {
    const double angle = i * 2 * M_PI / 7;
    positions.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
  }
  for (int i = 0; i < 7; ++i) {
    // The point on the side from the ring to the lower tip, at a third of it.
    const Vec3 third = positions[std::size_t(2 + i)] * (2.0 / 3) + positions[1] / 3;
    positions.push_back(third);
  }
  for (int i = 0; i < 7; ++i) {
    const int j = (i + 1) % 7, a = 2 + i, b = 2 + j, c = 9 + i, d = 9 + j;
    faces.push_back({a, b, 0});
    faces.push_back({b, a, c});
    faces.push_back({b, c, d});
    faces.push_back({d, c, 1});
  }
  const Mesh mesh = test::make_mesh(std::move(positions), faces);
  for (int g = 9; g < 16; ++g) {
    const WindowField field = propagate(mesh, {VertexId(g)});
    // Along the ring from point to point, in the shorter direction.
    const double step = (mesh.position(VertexId(10)) - mesh.position(VertexId(9))).norm();
    for (int v = 9; v < 16; ++v) {
      const int steps = std::min((v - g + 7) % 7, (g - v + 7) % 7);
      CHECK(field.distance[VertexId(v)] <= steps * step * (1 + 1e-9));
    }
  }
}

}  // namespace gvd::test_window_needles
