// The submesh that the exact solver of gvd::verify works on.
#include <cmath>
#include <set>

#include "../verify/src/path_submesh.hpp"
#include "gvd/error.hpp"
#include "gvd/verify.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_path_submesh {

PathSubmesh extract(const Mesh& mesh, const SurfacePoint& generator, const std::vector<SurfacePoint>& points) {
  return extract_path_submesh(mesh, {generator, points});
}

TEST_CASE(
    "path submesh: without points, and where every point is in a face of the generator, there is nothing to solve") {
  const Mesh grid = test::make_grid(3, 3);
  const PathSubmesh nothing = extract(grid, vertex_point(grid, VertexId(0)), {});
  CHECK_FALSE(nothing.source.valid());
  CHECK(nothing.targets.empty());
  const SurfacePoint centre = vertex_point(grid, VertexId(5));
  std::vector<SurfacePoint> near;
  for (const FaceId f : faces_around(grid, centre)) near.push_back(make_surface_point(f, {0.2, 0.3, 0.5}));
  near.push_back(centre);
  const PathSubmesh straight = extract(grid, centre, near);
  CHECK(straight.targets.empty());
  CHECK(straight.faces.empty());
  for (std::size_t i = 0; i < near.size(); ++i) {
    CHECK(straight.distances[i] == (position(grid, near[i]) - position(grid, centre)).norm());
  }
}

TEST_CASE("path submesh: a point of another component is at infinity, and is no target") {
  const Mesh mesh = test::make_two_components();
  const SurfacePoint far = vertex_point(mesh, VertexId(mesh.vertex_count() - 1));
  const PathSubmesh submesh = extract(mesh, vertex_point(mesh, VertexId(0)), {far});
  CHECK(std::isinf(submesh.distances[0]));
  CHECK(submesh.targets.empty());
}

TEST_CASE("path submesh: points and generators in no face are refused") {
  const Mesh mesh = test::make_triangle();
  const SurfacePoint good = vertex_point(mesh, VertexId(0)), bad{FaceId(1), {1, 0, 0}}, none{FaceId(), {1, 0, 0}};
  CHECK_THROWS_AS(extract(mesh, bad, {good}), Error);
  CHECK_THROWS_AS(extract(mesh, good, {bad}), Error);
  CHECK_THROWS_AS(extract(mesh, good, {none}), Error);
}

TEST_CASE("path submesh: the faces of the generator are split at it, except along sides that contain it") {
  const Mesh grid = test::make_grid(6, 1);
  const std::vector<SurfacePoint> far{vertex_point(grid, VertexId(13))};
  const auto split = [&](const SurfacePoint& generator) {
    const PathSubmesh submesh = extract(grid, generator, far);
    int at_source = 0;
    for (const auto& f : submesh.faces) at_source += std::count(f.begin(), f.end(), submesh.source) == 1;
    return at_source;
  };
  CHECK(split(make_surface_point(FaceId(0), {0.2, 0.3, 0.5})) == 3);
  CHECK(split(edge_point(Mesh::halfedge(FaceId(0), 2), 0.5)) == 4);  // the diagonal: two triangles on each side
  CHECK(split(vertex_point(grid, VertexId(0))) == 2);                // each of its two faces stays whole
}

TEST_CASE("path submesh: only what a path of the farthest point's length can visit is in it") {
  const Mesh strip = test::make_grid(40, 1);
  const PathSubmesh submesh = extract(strip, vertex_point(strip, VertexId(0)), {vertex_point(strip, VertexId(4))});
  CHECK(submesh.faces.size() >= 8);
  CHECK(submesh.faces.size() < 20);
}

TEST_CASE("path submesh: on every family it is an oriented manifold, and its targets are the points") {
  for (const auto& [name, mesh] : test::small_family()) {
    CAPTURE(name);
    const auto generators = test::random_generators(mesh, 3, 4), points = test::random_generators(mesh, 6, 9);
    for (const SurfacePoint& generator : generators) {
      const PathSubmesh submesh = extract(mesh, generator, points);
      std::set<std::pair<VertexId, VertexId>> halfedges;
      for (const auto& f : submesh.faces) {
        for (std::size_t i = 0; i < 3; ++i) {
          CHECK(f[i] != f[(i + 1) % 3]);
          CHECK(halfedges.insert({f[i], f[(i + 1) % 3]}).second);
        }
      }
      for (const PathSubmesh::Target& t : submesh.targets) {
        Vec3 at = Vec3::Zero();
        const auto& corners = submesh.faces[t.face.index()];
        for (std::size_t i = 0; i < 3; ++i) at += t.bary[i] * submesh.positions[corners[i].index()];
        CHECK((at - position(mesh, points[t.point])).norm() < 1e-12);
        CHECK(std::isnan(submesh.distances[t.point]));
      }
      if (submesh.source.valid()) {
        const Vec3& source = submesh.positions[submesh.source.index()];
        CHECK((source - position(mesh, generator)).norm() < 1e-15);
      }
    }
  }
}

TEST_CASE("path submesh: distances through it are symmetric") {
  const Mesh mesh = test::make_genus3(3);
  const auto points = test::random_generators(mesh, 5, 2);
  std::vector<DistanceQuery> queries;
  for (const SurfacePoint& p : points) queries.push_back({p, points});
  const auto distance = compute_exact_distances(mesh, queries);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) CHECK(distance[i][k] == Approx(distance[k][i]).epsilon(1e-9));
  }
}

}  // namespace gvd::test_path_submesh
