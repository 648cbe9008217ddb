#include <array>
#include <cmath>
#include <numbers>

#include "geodesic/windows/vertex_fan.hpp"
#include "support/catch.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_vertex_fan {

/// A flat fan of six equilateral triangles round vertex 0, face i between the directions i and i + 1 times 60 degrees.
Mesh make_hexagon() {
  std::vector<Vec3> positions{{0, 0, 0}};
  std::vector<std::array<int, 3>> faces;
  for (int i = 0; i < 6; ++i) {
    positions.emplace_back(std::cos(i * std::numbers::pi / 3), std::sin(i * std::numbers::pi / 3), 0);
    faces.push_back({0, 1 + i, 1 + (i + 1) % 6});
  }
  return test::make_mesh(std::move(positions), faces);
}

Rotation rotation(double angle) { return {std::cos(angle), std::sin(angle)}; }

TEST_CASE("straight through a flat vertex is the opposite direction, on both sides") {
  const Mesh mesh = make_hexagon();
  const FaceFrames frames(mesh, ParallelChunks(1, {}));
  const VertexFan fan(frames);
  for (int i = 0; i < 6; ++i) {
    for (const double angle : {0.2, 0.5, 0.9}) {
      const FanRay ray{Mesh::halfedge(FaceId(i), 0), rotation(angle)};
      for (const FanRay& straight : {fan.straight_left(ray), fan.straight_right(ray)}) {
        CHECK(straight.halfedge == Mesh::halfedge(FaceId((i + 3) % 6), 0));
        CHECK(straight.angle.cosine == Approx(std::cos(angle)).epsilon(1e-14));
        CHECK(straight.angle.sine == Approx(std::sin(angle)).epsilon(1e-14));
      }
    }
  }
}

TEST_CASE("a fan goes round a vertex inside, and ends at the boundary") {
  const FaceFrames frames(make_hexagon(), ParallelChunks(1, {}));
  const VertexFan fan(frames);
  const HalfedgeId inside = Mesh::halfedge(FaceId(0), 0);
  CHECK(fan.left_of(inside) == Mesh::halfedge(FaceId(1), 0));
  CHECK(fan.right_of(inside) == Mesh::halfedge(FaceId(5), 0));
  // Vertex 1 lies on the boundary, in the faces 5 and 0.
  CHECK(fan.left_of(Mesh::halfedge(FaceId(0), 1)) == Mesh::halfedge(FaceId(5), 2));
  CHECK_FALSE(fan.left_of(Mesh::halfedge(FaceId(5), 2)).valid());
  CHECK_FALSE(fan.right_of(Mesh::halfedge(FaceId(0), 1)).valid());
}

TEST_CASE("a vertex with a total angle below pi has no straight continuation, and the search for one ends") {
  const auto face = [](int a, int b) { return std::array{VertexId(0), VertexId(a), VertexId(b)}; };
  const FaceFrames frames(
      Mesh({{0, 0, 1}, {0.1, 0, 0}, {0, 0.1, 0}, {-0.1, -0.1, 0}}, {face(1, 2), face(2, 3), face(3, 1)}),
      ParallelChunks(1, {}));
  const VertexFan fan(frames);
  CHECK_FALSE(fan.straight_left({HalfedgeId(0), {}}).valid());
  CHECK_FALSE(fan.straight_right({HalfedgeId(0), {}}).valid());
}

TEST_CASE("a direction back is not grazing") {
  CHECK(Rotation{1, 1e-12}.is_grazing());
  CHECK_FALSE(Rotation{-1, 1e-12}.is_grazing());
  CHECK_FALSE(Rotation{1, 1e-6}.is_grazing());
}

TEST_CASE("a vertex sends a window between the points at which its rays meet the opposite side") {
  const FaceFrames frames(make_hexagon(), ParallelChunks(1, {}));
  const FaceFrame& f = frames.frame[FaceId(0)];
  const HalfedgeId outgoing = Mesh::halfedge(FaceId(0), 0);
  const VertexPath path{4, GeneratorId(7), {}};
  const Window whole = window_from_vertex(f, {outgoing, nullptr, nullptr}, path);
  CHECK(whole.begin == 0);
  CHECK(whole.end == f.length[1]);
  CHECK(whole.x == Approx(0.5));
  CHECK(whole.depth == Approx(std::sqrt(0.75)));
  CHECK(whole.offset == 4);
  CHECK(whole.generator == GeneratorId(7));
  CHECK_FALSE(whole.halfedge.valid());  // the boundary
  // Seen from the far side, the first ray counter-clockwise bounds the end of the interval.
  const Rotation middle = rotation(std::numbers::pi / 6);
  CHECK(window_from_vertex(f, {outgoing, &middle, nullptr}, path).end == Approx(0.5));
  CHECK(window_from_vertex(f, {outgoing, nullptr, &middle}, path).begin == Approx(0.5));
}

}  // namespace gvd::test_vertex_fan
