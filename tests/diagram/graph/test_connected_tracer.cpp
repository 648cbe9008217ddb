// The rounds that connect cells, with a tracer made by hand that leaves islands where a test wants them.
#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "base/parallel_chunks.hpp"
#include "diagram/graph/connected_tracer.hpp"
#include "diagram/growth/assemble_faces.hpp"
#include "diagram/growth/rough_bisectors.hpp"
#include "gvd/error.hpp"
#include "support/catch.hpp"
#include "support/edge_between.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/stages.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_connected_tracer {

using Edges = std::vector<EdgeId>;

/// Crosses every edge between two labels in its middle, and assembles all faces. Notes what it is asked for.
struct MiddleTracer final : DiagramTracer {
  explicit MiddleTracer(const test::Stages& of) : stages(of) {}

  const test::Stages& stages;
  std::function<void(Crossings&)> poke{};      ///< changes the first crossings
  std::function<void(TracedDiagram&)> grow{};  ///< changes the diagram before its faces are assembled
  mutable std::vector<Edges> crossed_again{}, disabled{};
  int rounds = 0;

  Crossings cross_edges(const NearestLabels& labels) const override {
    Edges all;
    for (int e = 0; e < stages.mesh().edge_count(); ++e) all.emplace_back(e);
    Crossings crossings(stages.mesh().edge_count(), middles(all, labels));
    if (poke) poke(crossings);
    return crossings;
  }

  void cross_at_most_once(const Edges& edges, const NearestLabels& labels, Crossings& crossings) const override {
    crossed_again.push_back(edges);
    crossings.replace(edges, middles(edges, labels));
  }

  void close_faces(TracedDiagram& traced) override {
    ++rounds;
    if (grow) grow(traced);
    const GrowthInput input{stages.working, stages.table(), traced.labels, stages.front};
    assemble_faces(input, traced.crossings, {}, traced.faces);
  }

  void disable_growth(const Edges& edges) override { disabled.push_back(edges); }

 private:
  std::vector<Crossing> middles(const Edges& edges, const NearestLabels& labels) const {
    std::vector<Crossing> items;
    for (const EdgeId e : edges) {
      const HalfedgeId h = stages.mesh().halfedge(e);
      const GeneratorId from = labels.label[stages.mesh().from(h)], to = labels.label[stages.mesh().to(h)];
      if (from != to) items.push_back({e, 0.5, from, to});
    }
    return items;
  }
};

/// A flat grid with generators at two opposite corners. Vertex 8 is next to generator 0.
struct TwoCells {
  Mesh mesh = test::make_grid(6, 6);
  test::Stages stages{mesh, test::at_vertices(mesh, {0, 48}), Front::circle};
  MiddleTracer tracer{stages};
  const VertexId inner{8};

  TracedDiagram trace(const NearestLabels& labels) {
    return trace_connected(stages.working, labels, tracer, Progress());
  }
  TracedDiagram trace() { return trace(stages.labels); }

  EdgeId edge(int u, int v) const { return test::edge_between(mesh, u, v); }
  Edges all_edges() const {
    Edges all;
    for (int e = 0; e < mesh.edge_count(); ++e) all.emplace_back(e);
    return all;
  }
  Edges edges_at(VertexId v) const {
    Edges edges;
    for (int e = 0; e < mesh.edge_count(); ++e) {
      const HalfedgeId h = mesh.halfedge(EdgeId(e));
      if (mesh.from(h) == v || mesh.to(h) == v) edges.emplace_back(e);
    }
    return edges;
  }
  /// Moves the inner vertex to cell 1, as growth might.
  void move_inner(TracedDiagram& traced) const {
    traced.labels.label[inner] = GeneratorId(1);
    traced.moved.push_back(inner);
    std::vector<Crossing> items;
    for (const EdgeId e : edges_at(inner)) {
      const bool begins = mesh.from(mesh.halfedge(e)) == inner;
      items.push_back({e, 0.5, GeneratorId(begins ? 1 : 0), GeneratorId(begins ? 0 : 1)});
    }
    traced.crossings.replace(edges_at(inner), items);
  }
};

bool contains(const Edges& edges, EdgeId e) { return std::binary_search(edges.begin(), edges.end(), e); }

std::vector<std::int32_t> ones(std::size_t count) { return std::vector<std::int32_t>(count, 1); }

TEST_CASE("one generator: one round, and nothing to connect") {
  const Mesh mesh = test::make_grid(3, 3);
  const test::Stages stages(mesh, test::at_vertices(mesh, {5}), Front::circle);
  MiddleTracer tracer{stages};
  const TracedDiagram traced = trace_connected(stages.working, stages.labels, tracer, Progress());
  CHECK(traced.crossings.size() == 0);
  CHECK(traced.faces.arcs.empty());
  CHECK(traced.cell_components.raw() == ones(1));
  CHECK(tracer.rounds == 1);
  CHECK((tracer.crossed_again.empty() && tracer.disabled.empty()));
}

TEST_CASE("connected cells take one round") {
  TwoCells cells;
  const TracedDiagram traced = cells.trace();
  CHECK(traced.cell_components.raw() == ones(2));
  CHECK(traced.counts.relabelled_vertices == 0);
  CHECK_FALSE(traced.faces.arcs.empty());
  CHECK(cells.tracer.rounds == 1);
  CHECK((cells.tracer.crossed_again.empty() && cells.tracer.disabled.empty()));
  CHECK(&traced.nearest() == &traced.labels);
  CHECK(&traced.first_crossings() == &traced.crossings);
}

TEST_CASE("an edge with a disconnected interval is crossed again before the faces are closed") {
  TwoCells cells;
  const EdgeId e = cells.edge(1, 8);
  cells.tracer.poke = [&](Crossings& crossings) {
    crossings.replace({e}, {{e, 0.4, GeneratorId(0), GeneratorId(1)}, {e, 0.6, GeneratorId(1), GeneratorId(0)}});
  };
  const TracedDiagram traced = cells.trace();
  CHECK(traced.crossings.count(e) == 0);
  CHECK(traced.first_crossings().count(e) == 2);
  CHECK(traced.first_crossings().size() == traced.crossings.size() + 2);
  CHECK(traced.cell_components.raw() == ones(2));
  CHECK(cells.tracer.rounds == 1);
  CHECK(cells.tracer.crossed_again == std::vector<Edges>{{e}});
  CHECK(cells.tracer.disabled.empty());
}

TEST_CASE("an island of the labels takes the label of a neighbour") {
  TwoCells cells;
  const Progress silent;
  auto label = cells.stages.labels.label;
  label[cells.inner] = GeneratorId(1);
  const NearestLabels labels =
      take_labels(cells.stages.working, cells.stages.labels.distance, label, ParallelChunks(1, silent));
  const TracedDiagram traced = cells.trace(labels);
  CHECK(traced.labels.label[cells.inner] == GeneratorId(0));
  CHECK(traced.counts.relabelled_vertices == 1);
  REQUIRE(traced.labels_before);
  CHECK(traced.labels_before->label.raw() == labels.label.raw());
  CHECK(traced.labels_before->distance.raw() == labels.distance.raw());
  CHECK(traced.cell_components.raw() == ones(2));
  CHECK(cells.tracer.rounds == 2);
  REQUIRE(cells.tracer.crossed_again.size() == 1);
  for (const EdgeId e : cells.edges_at(cells.inner)) {
    CHECK(contains(cells.tracer.crossed_again[0], e));
    CHECK(traced.crossings.count(e) == 0);
  }
}

TEST_CASE("an island that growth made is not relabelled: growth is disabled there") {
  TwoCells cells;
  cells.tracer.grow = [&](TracedDiagram& traced) {
    if (cells.tracer.disabled.empty()) cells.move_inner(traced);
  };
  const TracedDiagram traced = cells.trace();
  CHECK(traced.labels.label == cells.stages.labels.label);
  CHECK(traced.moved.empty());
  CHECK(traced.counts.relabelled_vertices == 0);
  CHECK(cells.tracer.rounds == 2);
  REQUIRE(cells.tracer.disabled.size() == 1);
  CHECK(std::is_sorted(cells.tracer.disabled[0].begin(), cells.tracer.disabled[0].end()));
  for (const EdgeId e : cells.edges_at(cells.inner)) CHECK(contains(cells.tracer.disabled[0], e));
  CHECK_FALSE(contains(cells.tracer.disabled[0], cells.edge(40, 41)));
}

TEST_CASE("edges that were crossed at most once stay so in later rounds") {
  TwoCells cells;
  const EdgeId poked = cells.edge(2, 3);
  cells.tracer.poke = [&](Crossings& crossings) {
    crossings.replace({poked},
                      {{poked, 0.4, GeneratorId(0), GeneratorId(1)}, {poked, 0.6, GeneratorId(1), GeneratorId(0)}});
  };
  cells.tracer.grow = [&](TracedDiagram& traced) {
    if (cells.tracer.disabled.empty()) cells.move_inner(traced);
  };
  cells.trace();
  REQUIRE(cells.tracer.crossed_again.size() == 2);
  CHECK(cells.tracer.crossed_again[0] == Edges{poked});
  CHECK(contains(cells.tracer.crossed_again[1], poked));
  CHECK(cells.tracer.crossed_again[1].size() > cells.edges_at(cells.inner).size());
}

TEST_CASE("after twelve rounds growth is disabled on all edges, and all are crossed at most once") {
  TwoCells cells;
  cells.tracer.grow = [&](TracedDiagram& traced) {  // stubborn: stops only where all edges are meant
    const auto& disabled = cells.tracer.disabled;
    if (disabled.empty() || disabled.back() != cells.all_edges()) cells.move_inner(traced);
  };
  const TracedDiagram traced = cells.trace();
  CHECK(cells.tracer.rounds == 14);
  CHECK(cells.tracer.disabled.size() == 13);
  CHECK(cells.tracer.crossed_again.back() == cells.all_edges());
  CHECK(traced.cell_components.raw() == ones(2));
}

TEST_CASE("tracing begins with the step \"bisectors\", where it can be cancelled") {
  TwoCells cells;
  const Progress cancel = [](std::string_view step, double fraction) {
    CHECK((step == "bisectors" && fraction == 0));
    return false;
  };
  try {
    trace_connected(cells.stages.working, cells.stages.labels, cells.tracer, cancel);
    FAIL("was not cancelled");
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::interrupted);
  }
  CHECK(cells.tracer.rounds == 0);
}

TEST_CASE("a tracer without growth has nothing to disable") {
  struct WithoutGrowth final : DiagramTracer {
    Crossings cross_edges(const NearestLabels&) const override { return {}; }
    void cross_at_most_once(const Edges&, const NearestLabels&, Crossings&) const override {}
    void close_faces(TracedDiagram&) override {}
  };
  WithoutGrowth tracer;
  CHECK_NOTHROW(tracer.disable_growth({EdgeId(0)}));
  CHECK(tracer.cross_edges(NearestLabels()).size() == 0);
}

const GeneratorId kOwn(0), kOther(1), kThird(2);

/// Two squares, cut by the edges 0 - 4 and 1 - 5; generator 0 owns all six corners.
struct TwoSquares {
  Mesh mesh = test::make_grid(2, 1);
  NearestLabels labels;

  TwoSquares() {
    labels.label.assign(6, kOwn);
    labels.distance.assign(6, 1.0);
  }

  EdgeId edge(int u, int v) const { return test::edge_between(mesh, u, v); }

  /// Edges with an interval of the other cell in their middle.
  Crossings intervals(std::vector<EdgeId> edges) const {
    std::sort(edges.begin(), edges.end());
    std::vector<Crossing> items;
    for (const EdgeId e : edges) {
      items.push_back({e, 0.4, kOwn, kOther});
      items.push_back({e, 0.6, kOther, kOwn});
    }
    return Crossings(mesh.edge_count(), items);
  }

  std::vector<EdgeId> find(const Crossings& crossings) const {
    return find_disconnected_intervals(mesh, labels, crossings);
  }
};

TEST_CASE("without crossings, and with one on each edge, there is no interval inside an edge") {
  TwoSquares squares;
  CHECK(squares.find(squares.intervals({})).empty());
  squares.labels.label[VertexId(2)] = kOther;
  std::vector<Crossing> items;
  for (int e = 0; e < squares.mesh.edge_count(); ++e) {
    const HalfedgeId h = squares.mesh.halfedge(EdgeId(e));
    const GeneratorId from = squares.labels.label[squares.mesh.from(h)], to = squares.labels.label[squares.mesh.to(h)];
    if (from != to) items.push_back({EdgeId(e), 0.5, from, to});
  }
  REQUIRE(items.size() >= 2);
  CHECK(squares.find(Crossings(squares.mesh.edge_count(), items)).empty());
}

TEST_CASE("a single interval inside an edge is disconnected, on the boundary too") {
  const TwoSquares squares;
  for (const EdgeId e : {squares.edge(1, 4), squares.edge(0, 1)}) {
    CHECK(squares.find(squares.intervals({e})) == std::vector<EdgeId>{e});
  }
}

TEST_CASE("two intervals in one face are connected to each other, and still disconnected from every corner") {
  const TwoSquares squares;
  const EdgeId middle = squares.edge(1, 4), side = squares.edge(0, 1);
  const std::vector<EdgeId> both{std::min(middle, side), std::max(middle, side)};
  CHECK(squares.find(squares.intervals(both)) == both);
}

TEST_CASE("a chain of intervals through common faces connects to a corner of the cell") {
  TwoSquares squares;
  squares.labels.label[VertexId(2)] = kOther;  // has no face in common with the middle edge
  const EdgeId middle = squares.edge(1, 4), between = squares.edge(1, 5);
  CHECK(squares.find(squares.intervals({middle})) == std::vector<EdgeId>{middle});
  CHECK(squares.find(squares.intervals({middle, between})).empty());
}

TEST_CASE("a corner of a third cell does not connect, and an edge with two intervals is named once") {
  TwoSquares squares;
  squares.labels.label[VertexId(2)] = kThird;
  const EdgeId e = squares.edge(1, 4);
  CHECK(squares.find(squares.intervals({e})) == std::vector<EdgeId>{e});
  const Crossings twice(
      squares.mesh.edge_count(),
      {{e, 0.2, kOwn, kOther}, {e, 0.4, kOther, kOwn}, {e, 0.6, kOwn, kThird}, {e, 0.8, kThird, kOwn}});
  // The interval of the cell itself, in between, is connected to the edge's ends.
  CHECK(squares.find(twice) == std::vector<EdgeId>{e});
}

}  // namespace gvd::test_connected_tracer
