// The paper's steps: distances of midpoints (section 4.1), rough segments and their refinement (section 4.2, inset
// figure and figure 6), and complete diagrams.
#include <cmath>

#include "diagram/growth/trace_paper.hpp"
#include "gvd/check.hpp"
#include "gvd/diagram.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/same_diagram.hpp"
#include "support/stages.hpp"

namespace gvd::test_trace_paper {

TEST_CASE("the paper's steps give complete diagrams on all families, with both fronts") {
  std::int64_t gaps = 0, grown = 0;
  for (const auto& [name, mesh] : test::small_family()) {
    for (const Front front : {Front::planar, Front::circle}) {
      for (unsigned seed = 0; seed < 3; ++seed) {
        INFO(name << ", seed " << seed);
        DiagramOptions options;
        options.method = Method::paper;
        options.front = front;
        const Diagram diagram = compute_diagram(mesh, test::random_generators(mesh, 20, seed), options);
        REQUIRE(check_diagram(mesh, diagram).ok());
        gaps += diagram.report.gaps;
        grown += diagram.report.gaps_grown;
      }
    }
  }
  CHECK(gaps > 500);
  CHECK(2 * grown > gaps);
  CHECK(grown < gaps);
}

TEST_CASE("the paper's steps work with exact distances too, as every solver with every tracer") {
  const Mesh mesh = test::make_torus(24, 12);
  DiagramOptions options;
  options.method = {Solver::windows, Tracer::paper};
  const Diagram diagram = compute_diagram(mesh, test::random_generators(mesh, 10, 1), options);
  CHECK(check_diagram(mesh, diagram).ok());
}

constexpr int kSquares = 12;
int at(int i, int j) { return j * (kSquares + 1) + i; }

TEST_CASE("rough segments cross every edge between two labels at its midpoint, and no other") {
  const Mesh mesh = test::make_bumpy_sphere(2, 1);
  const test::Stages stages(mesh, test::random_generators(mesh, 8, 4), Front::planar);
  const Crossings crossings = find_rough_segments(stages.mesh(), stages.labels);
  CHECK(crossings.size() > 30);
  for (std::int32_t i = 0; i < stages.mesh().edge_count(); ++i) {
    const EdgeId e(i);
    const HalfedgeId h = stages.mesh().halfedge(e);
    const GeneratorId from = stages.labels.label[stages.mesh().from(h)], to = stages.labels.label[stages.mesh().to(h)];
    REQUIRE(crossings.count(e) == (from == to ? 0 : 1));
    if (from == to) continue;
    const Crossing& c = crossings[crossings.first(e)];
    REQUIRE(c.t == 0.5);
    REQUIRE(c.before == from);
    REQUIRE(c.after == to);
  }
}

TEST_CASE("edges are put back to their midpoints, or to no crossing") {
  const Mesh mesh = test::make_grid(kSquares, kSquares);
  test::Stages stages(mesh, test::at_vertices(mesh, {at(2, 6), at(9, 6)}), Front::planar);
  Crossings crossings = find_rough_segments(mesh, stages.labels);
  const std::vector<EdgeId> edges{crossings.items().front().edge, crossings.items().back().edge};
  crossings[CrossingId(0)].t = 0.125;
  const HalfedgeId h = mesh.halfedge(edges[1]);
  stages.labels.label[mesh.to(h)] = stages.labels.label[mesh.from(h)];
  const Progress silent;
  const PaperTracer tracer(stages.working, stages.table(), Front::planar, silent);
  tracer.cross_at_most_once(edges, stages.labels, crossings);
  CHECK(crossings[crossings.first(edges[0])].t == 0.5);
  CHECK(crossings.count(edges[1]) == 0);
}

TEST_CASE("refined segments come near to the bisector of two generators in the plane") {
  const Mesh mesh = test::make_grid(kSquares, kSquares);
  // The bisector is x = 5.7; all rough segments lie between x = 5 and x = 6.
  const test::Stages stages(
      mesh, {vertex_point(mesh, VertexId(at(2, 6))), make_surface_point(FaceId(2 * (6 * kSquares + 9)), {0.6, 0.4, 0})},
      Front::circle);
  const Mesh& working = stages.mesh();
  Crossings crossings = find_rough_segments(working, stages.labels);
  const auto mean_error = [&] {
    double sum = 0;
    for (const Crossing& c : crossings.items()) {
      sum += std::abs(position(working, edge_point(working.halfedge(c.edge), c.t)).x() - 5.7);
    }
    return sum / static_cast<double>(crossings.size());
  };
  const double rough = mean_error();
  const auto estimates = refine_segments(working, stages.table(), crossings);
  CHECK(estimates.size() > 20);
  weld_crossings(estimates, crossings);
  CHECK(rough > 0.15);
  CHECK(mean_error() < 0.25 * rough);
}

TEST_CASE("the distance at an edge midpoint is the mean of those at the edge's ends, for every entry of the tables") {
  const Mesh mesh = test::make_sphere(2);
  const test::Stages stages(mesh, test::random_generators(mesh, 9, 1), Front::planar);
  std::size_t entries = 0;
  for (std::int32_t i = 0; i < stages.mesh().face_count(); ++i) {
    const FaceId f(i);
    stages.table().for_each(f, [&](const TableEntry& entry) {
      const auto middle = find_midpoint_distances(stages.table(), f, entry.generator);
      REQUIRE(middle);
      const auto corner = stages.table().corner_distances(entry);
      for (std::size_t k = 0; k < 3; ++k) REQUIRE((*middle)[k] == 0.5 * (corner[k] + corner[(k + 1) % 3]));
      ++entries;
    });
  }
  CHECK(entries > static_cast<std::size_t>(mesh.face_count()));
  CHECK_FALSE(find_midpoint_distances(stages.table(), FaceId(0), GeneratorId(9)));
}

}  // namespace gvd::test_trace_paper
