#include <algorithm>
#include <cmath>
#include <limits>

#include "geodesic/marching/marched_distances.hpp"
#include "geodesic/symbolic_offset.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/stages.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_marched_distances {

/// Twice the largest symbolic offset, in edges of about 1: what a straight distance on a flat mesh may be off.
constexpr double kOffset = 5e-9;

double least(const std::vector<EdgeSource>& sources, double t) {
  double d = std::numeric_limits<double>::infinity();
  for (const EdgeSource& s : sources) d = std::min(d, s.distance(t));
  return d;
}

double least(const std::vector<FaceSource>& sources, const Vec2& p) {
  double d = std::numeric_limits<double>::infinity();
  for (const FaceSource& s : sources) d = std::min(d, s.distance(p));
  return d;
}

TEST_CASE("with one generator no edge is contested") {
  const Mesh mesh = test::make_sphere(1);
  const test::Stages one(mesh, test::at_vertices(mesh, {0}), Front::circle);
  CHECK(MarchedDistances(one.mesh(), one.table()).contested_edges(ParallelChunks(1, {})).empty());
}

TEST_CASE("every edge between two labels is contested") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    const test::Stages stages(mesh, test::random_generators(mesh, 12, 3), Front::circle);
    const auto edges = MarchedDistances(stages.mesh(), stages.table()).contested_edges(ParallelChunks(1, {}));
    CHECK(std::is_sorted(edges.begin(), edges.end()));
    for (int e = 0; e < stages.mesh().edge_count(); ++e) {
      const HalfedgeId h = stages.mesh().halfedge(EdgeId(e));
      if (stages.labels.label[stages.mesh().from(h)] == stages.labels.label[stages.mesh().to(h)]) continue;
      REQUIRE(std::binary_search(edges.begin(), edges.end(), EdgeId(e)));
    }
  }
}

TEST_CASE("on a flat grid the least distance over the sources is the straight one, on edges and in faces") {
  const Mesh mesh = test::make_grid(8, 6);
  const test::Stages stages(mesh, test::at_vertices(mesh, {4 * 9 + 4}), Front::circle);
  const Vec3 from = mesh.position(VertexId(4 * 9 + 4));
  const MarchedDistances distances(stages.mesh(), stages.table());
  std::vector<EdgeSource> on_edge;
  for (int e = 0; e < mesh.edge_count(); ++e) {
    const HalfedgeId h = mesh.halfedge(EdgeId(e));
    distances.collect(EdgeId(e), on_edge);
    REQUIRE(on_edge.size() >= 2);
    for (const double fraction : {0.0, 0.3, 1.0}) {
      const Vec3 p = (1 - fraction) * mesh.position(mesh.from(h)) + fraction * mesh.position(mesh.to(h));
      REQUIRE(std::abs(least(on_edge, fraction * mesh.length(h)) - (p - from).norm()) < kOffset);
    }
  }
  std::vector<FaceSource> in_face;
  for (int f = 0; f < mesh.face_count(); ++f) {
    const FaceLayout layout(mesh, FaceId(f));
    distances.collect(FaceId(f), layout, in_face);
    const auto& [a, b, c] = mesh.vertices(FaceId(f));
    const Vec3 p = (mesh.position(a) + mesh.position(b) + mesh.position(c)) / 3;
    REQUIRE(std::abs(least(in_face, layout.at({1.0 / 3, 1.0 / 3, 1.0 / 3})) - (p - from).norm()) < kOffset);
  }
}

TEST_CASE("the sources of an edge's ends come first, with the labels and distances of its vertices") {
  const Mesh mesh = test::make_torus(12, 8);
  const test::Stages stages(mesh, test::random_generators(mesh, 8, 1), Front::circle);
  const MarchedDistances distances(stages.mesh(), stages.table());
  std::vector<EdgeSource> sources;
  for (int e = 0; e < stages.mesh().edge_count(); ++e) {
    distances.collect(EdgeId(e), sources);
    const HalfedgeId h = stages.mesh().halfedge(EdgeId(e));
    REQUIRE(sources[0].generator.valid());
    REQUIRE(sources[0].distance(0) <= stages.labels.distance[stages.mesh().from(h)]);
    REQUIRE(sources[1].distance(stages.mesh().length(h)) <= stages.labels.distance[stages.mesh().to(h)]);
  }
}

}  // namespace gvd::test_marched_distances
