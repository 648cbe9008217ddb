// The steps of the growth tracer, one by one.
#include <algorithm>
#include <string>
#include <vector>

#include "diagram/growth/gap_tracer.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/same_crossings.hpp"
#include "support/stages.hpp"

namespace gvd::test_gap_tracer {

std::vector<EdgeId> all_edges(const Mesh& mesh) {
  std::vector<EdgeId> edges;
  for (int e = 0; e < mesh.edge_count(); ++e) edges.emplace_back(e);
  return edges;
}

/// A sphere with gaps that growth closes.
struct Sphere {
  Mesh mesh = test::make_sphere(3);
  test::Stages stages{mesh, test::random_generators(mesh, 30, 3), Front::circle};
  Progress silent;
  GrowthTracer tracer{stages.working, stages.table(), Front::circle, silent};

  TracedDiagram close() {
    TracedDiagram traced{stages.labels, tracer.cross_edges(stages.labels)};
    tracer.close_faces(traced);
    return traced;
  }
};

TEST_CASE("one generator: no crossings, no arcs, no gaps") {
  const Mesh mesh = test::make_grid(3, 3);
  const test::Stages stages(mesh, test::at_vertices(mesh, {5}), Front::planar);
  const Progress silent;
  GrowthTracer tracer(stages.working, stages.table(), Front::planar, silent);
  TracedDiagram traced{stages.labels, tracer.cross_edges(stages.labels)};
  tracer.close_faces(traced);
  CHECK(traced.crossings.size() == 0);
  CHECK(traced.faces.arcs.empty());
  CHECK(traced.counts.gaps == 0);
  CHECK(traced.counts.gaps_grown == 0);
}

TEST_CASE("edges are crossed as the rough bisectors do, and with circles the crossings stay outside of the gaps") {
  Sphere sphere;
  test::require_same_order(sphere.stages.rough, sphere.tracer.cross_edges(sphere.stages.labels));
  const std::vector<EdgeId> edges = all_edges(sphere.stages.mesh());
  sphere.tracer.disable_growth(edges);
  const TracedDiagram traced = sphere.close();
  REQUIRE(traced.crossings.size() == sphere.stages.rough.size());
  for (std::size_t i = 0; i < traced.crossings.size(); ++i) {
    REQUIRE(traced.crossings.items()[i].t == sphere.stages.rough.items()[i].t);
  }
}

TEST_CASE("growth closes gaps until it is disabled: then all of them are assembled") {
  Sphere sphere;
  const TracedDiagram grown = sphere.close();
  CHECK(grown.counts.gaps > 0);
  CHECK(grown.counts.gaps_grown > 0);
  CHECK(std::is_sorted(grown.faces.arcs.begin(), grown.faces.arcs.end(),
                       [](const FaceArc& a, const FaceArc& b) { return a.face < b.face; }));
  sphere.tracer.disable_growth({});
  CHECK(sphere.close().counts.gaps_grown == grown.counts.gaps_grown);
  sphere.tracer.disable_growth(all_edges(sphere.stages.mesh()));
  const TracedDiagram assembled = sphere.close();
  CHECK(assembled.counts.gaps == grown.counts.gaps);
  CHECK(assembled.counts.gaps_grown == 0);
  CHECK(assembled.moved.empty());
  CHECK_FALSE(assembled.faces.arcs.empty());
}

TEST_CASE("growth is disabled only in gaps that have one of the edges") {
  Sphere sphere;
  const auto gaps = find_gaps(sphere.stages.mesh(), sphere.stages.table());
  const std::int64_t before = sphere.close().counts.gaps_grown;
  std::int64_t fewer = before;
  for (const Gap& gap : gaps) {
    Sphere fresh;
    fresh.tracer.disable_growth({fresh.stages.mesh().edge(Mesh::halfedge(gap.faces.front(), 0))});
    const std::int64_t after = fresh.close().counts.gaps_grown;
    REQUIRE(after <= before);
    REQUIRE(after >= before - 2);  // an edge belongs to two gaps at most
    fewer = std::min(fewer, after);
  }
  CHECK(fewer < before);
}

TEST_CASE("edges crossed again have one crossing at most, and others keep theirs") {
  Sphere sphere;
  Crossings crossings = sphere.stages.rough;
  sphere.tracer.cross_at_most_once(all_edges(sphere.stages.mesh()), sphere.stages.labels, crossings);
  for (const EdgeId e : all_edges(sphere.stages.mesh())) REQUIRE(crossings.count(e) <= 1);
  Crossings untouched = sphere.stages.rough;
  sphere.tracer.cross_at_most_once({}, sphere.stages.labels, untouched);
  CHECK(untouched.size() == sphere.stages.rough.size());
}

}  // namespace gvd::test_gap_tracer
