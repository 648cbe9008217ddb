// Convex combination maps of discs: flat ones stay as they are, convex borders give maps without a turned face.
#include <cmath>
#include <vector>

#include "base/plane.hpp"
#include "mesh/flatten_disc.hpp"
#include "mesh/vertex_ring.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_flatten_disc {

std::vector<FaceId> all_faces(const Mesh& mesh) {
  std::vector<FaceId> faces;
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) faces.push_back(FaceId(f));
  return faces;
}

std::vector<VertexId> boundary_of(const Mesh& mesh) {
  VertexId first(0);
  while (!mesh.is_boundary(first)) first = VertexId(first.value() + 1);
  std::vector<VertexId> loop;
  HalfedgeId h = mesh.halfedge(first);
  do {
    loop.push_back(mesh.from(h));
    h = next_on_boundary(mesh, h);
  } while (mesh.from(h) != first);
  return loop;
}

std::vector<BorderPoint> on_circle(const Mesh& mesh) {
  const std::vector<VertexId> loop = boundary_of(mesh);
  std::vector<BorderPoint> border;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    border.push_back(
        {loop[i], unit_vector(6.283185307179586 * static_cast<double>(i) / static_cast<double>(loop.size()))});
  }
  return border;
}

TEST_CASE("flatten disc: mean values keep a flat disc") {
  const Mesh grid = test::make_grid(5, 7);
  std::vector<BorderPoint> border;
  for (const VertexId v : boundary_of(grid)) border.push_back({v, grid.position(v).head<2>()});
  const PlaneDisc disc = flatten_disc(grid, all_faces(grid), border, DiscWeights::mean_value);
  for (std::int32_t v = 0; v < grid.vertex_count(); ++v) {
    CHECK((disc.at(VertexId(v)) - grid.position(VertexId(v)).head<2>()).norm() < 1e-12);
  }
  CHECK(is_oriented(grid, all_faces(grid), disc));
}

TEST_CASE("flatten disc: on a circle, no face is turned, with either kind of weights") {
  const Mesh half = test::make_half_sphere(3);
  for (const DiscWeights weights : {DiscWeights::mean_value, DiscWeights::uniform}) {
    const PlaneDisc disc = flatten_disc(half, all_faces(half), on_circle(half), weights);
    CHECK(is_oriented(half, all_faces(half), disc));
    for (const Vec2& point : disc.points) CHECK(point.norm() < 1 + 1e-12);
  }
}

TEST_CASE("flatten disc: a border that crosses itself turns faces round") {
  const Mesh half = test::make_half_sphere(2);
  std::vector<BorderPoint> border = on_circle(half);
  for (BorderPoint& b : border) b.point.y() *= b.point.x();
  const PlaneDisc disc = flatten_disc(half, all_faces(half), border, DiscWeights::mean_value);
  CHECK(!is_oriented(half, all_faces(half), disc));
}

}  // namespace gvd::test_flatten_disc
