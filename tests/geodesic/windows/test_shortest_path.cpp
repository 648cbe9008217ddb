// The vertices at which paths bend, and properties of windows that need no reference.
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "geodesic/nearest_source.hpp"
#include "geodesic/windows/propagation/propagate_windows.hpp"
#include "geodesic/windows/shortest_path.hpp"
#include "geodesic/windows/window_sources.hpp"
#include "mesh/working_mesh.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_shortest_path {

/// Faces round vertex 0, whose `count` neighbours lie up and down alternately: a saddle if `height` is large enough.
Mesh make_crown(int count, double height) {
  std::vector<Vec3> positions{{0, 0, 0}};
  std::vector<std::array<int, 3>> faces;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    positions.emplace_back(std::cos(angle), std::sin(angle), i % 2 ? height : -height);
    faces.push_back({0, 1 + i, 1 + (i + 1) % count});
  }
  return test::make_mesh(std::move(positions), faces);
}

WindowField propagate(const Mesh& mesh, const std::vector<VertexId>& generators) {
  return propagate_windows(mesh, generators, {KeepWindows::all, {}}, {});
}

double distance_on_edge(const Mesh& mesh, const WindowField& field, HalfedgeId h, double t) {
  std::vector<EdgeSource> sources;
  collect_edge_sources(mesh, field, h, sources);
  double distance = 0;
  nearest_source(sources, t * mesh.length(h), distance);
  return distance;
}

TEST_CASE("paths continue from a saddle into the angle that no straight path reaches, and pass beside it elsewhere") {
  constexpr int kCount = 8;
  const Mesh mesh = make_crown(kCount, 0.4);
  const double spoke = mesh.position(VertexId(1)).norm();
  const double outer = (mesh.position(VertexId(2)) - mesh.position(VertexId(1))).norm();
  const double angle = 2 * std::asin(0.5 * outer / spoke), middle = std::sqrt(spoke * spoke - 0.25 * outer * outer);
  REQUIRE(2.5 * angle < std::numbers::pi);
  REQUIRE(3 * angle > std::numbers::pi);
  // In the plane, the faces between two rays from the saddle that are less than pi apart are one flat fan.
  const auto expected = [&](double turn, double radius) {
    if (turn >= std::numbers::pi) return spoke + radius;
    return std::sqrt(spoke * spoke + radius * radius - 2 * spoke * radius * std::cos(turn));
  };
  for (int g = 0; g < kCount; ++g) {
    const WindowField field = propagate(mesh, {VertexId(1 + g)});
    for (int i = 0; i < kCount; ++i) {
      const int steps = std::min((i - g + kCount) % kCount, (g - i + kCount) % kCount);
      CHECK(field.distance[VertexId(1 + i)] == Approx(expected(steps * angle, spoke)).epsilon(1e-14).margin(1e-15));
      // The middle of the outer edge between i and i + 1; it is halfedge 1 of face i.
      const int after = (i - g + kCount) % kCount, before = (g - i - 1 + kCount) % kCount;
      const double turn = (std::min(after, before) + 0.5) * angle;
      CHECK(distance_on_edge(mesh, field, Mesh::halfedge(FaceId(i), 1), 0.5) ==
            Approx(expected(turn, middle)).epsilon(1e-14));
    }
  }
}

TEST_CASE("a path that can't be continued from a vertex is not complete") {
  const Mesh mesh = make_crown(8, 0.4);
  const VertexId saddle(0), start(5), generator(1);
  WindowField field = propagate(mesh, {generator});
  PathMemo memo({generator});
  const GeodesicPath path = trace_shortest_path(mesh, field, memo, vertex_point(mesh, start));
  REQUIRE(path.complete);
  REQUIRE(path.points.size() == 3);
  CHECK(vertex(mesh, path.points[1]) == saddle);
  CHECK(vertex(mesh, path.points[2]) == generator);
  // Rounding may cause this: the saddle is nearer than all paths to it.
  field.distance[saddle] = -1;
  const GeodesicPath broken = trace_shortest_path(mesh, field, memo, vertex_point(mesh, start));
  CHECK_FALSE(broken.complete);
  CHECK(broken.generator.value() == 0);
  CHECK(vertex(mesh, broken.points.back()) == saddle);
}

TEST_CASE("saddles send windows, and no other vertex inside the surface") {
  // A generator is an event, and so is each vertex that paths bend at.
  CHECK(propagate(make_crown(8, 0), {VertexId(1)}).events == 1);    // flat
  CHECK(propagate(make_crown(8, 0.1), {VertexId(1)}).events == 2);  // a little more than 2 pi
  CHECK(propagate(test::make_sphere(2), {VertexId(1)}).events == 1);
}

TEST_CASE("one face, two faces, and a generator on every vertex") {
  for (const Mesh& mesh : {test::make_triangle(), test::make_pillow(), test::make_tetrahedron()}) {
    std::vector<VertexId> all;
    for (int v = 0; v < mesh.vertex_count(); ++v) all.emplace_back(v);
    const WindowField field = propagate(mesh, all);
    for (const VertexId v : all) {
      CHECK(field.distance[v] == 0);
      CHECK(field.label[v].value() == v.value());
      const WindowField single = propagate(mesh, {v});
      for (const VertexId other : all) {
        // On these meshes no path is shorter than the edge.
        const double straight = (mesh.position(v) - mesh.position(other)).norm();
        CHECK(single.distance[other] == Approx(straight).epsilon(1e-15).margin(0));
      }
    }
  }
}

TEST_CASE("every window is a path of its generator, and none is shorter than the exact distance from it") {
  for (const auto& [name, input] : test::small_family()) {
    INFO(name);
    const WorkingMesh working(input, test::random_generators(input, 6, 44));
    const Mesh& mesh = working.mesh();
    const auto& generators = working.generator_vertices().raw();
    const WindowField field = propagate(mesh, generators);
    std::vector<WindowField> alone;
    for (const VertexId v : generators) alone.push_back(propagate(mesh, {v}));
    double worst = 0;
    for (int f = 0; f < mesh.face_count(); ++f) {
      field.windows.for_each(FaceId(f), [&](const Window& w) {
        const HalfedgeId h = w.halfedge;
        const double length = mesh.length(h);
        for (const double fraction : {0.0, 0.5, 1.0}) {
          const double t = w.begin + fraction * (w.end - w.begin), from_start = mesh.twin(h).valid() ? t : length - t;
          const double least = distance_on_edge(mesh, alone[w.generator.index()], h, from_start / length);
          worst = std::max(worst, least - w.distance(t));
        }
      });
    }
    CHECK(worst <= 1e-13 * mesh.bbox_diagonal());
  }
}

}  // namespace gvd::test_shortest_path
