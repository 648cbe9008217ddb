// The rounds that connect every cell, around any tracer.
//
// The edges are crossed and the faces closed. Then every piece of a cell must be connected to the cell's generator.
// Around a piece that is not, growth is disabled, vertices take the label of a neighbour, edges are crossed at most
// once, and the faces are closed again. After a fixed number of rounds, all edges are crossed at most once, between
// labels that edges join to their generators. Such cells are connected by construction.
// Source: the paper does not treat this; see docs/developer/algorithm.md.
#include "diagram/graph/connected_tracer.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

#include "base/sort_unique.hpp"
#include "base/union_find.hpp"
#include "diagram/graph/cell_components.hpp"
#include "gvd/diagram_steps.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

/// Number of rounds of local repair before the last resort. The meshes of docs/developer/performance.md take one or
/// two.
constexpr int kMaxRounds = 12;

/// Stands for all corners among the label intervals. An interval has the index of the crossing at its end, which is
/// never 0.
constexpr std::int32_t kCorners = 0;

/// Unites the label intervals inside the edges of a face, and its corners, that have the same label.
void unite_in_face(const Mesh& mesh, const NearestLabels& labels, const Crossings& crossings, FaceId f,
                   UnionFind& groups) {
  std::vector<std::pair<GeneratorId, std::int32_t>> in_face;
  for (const VertexId v : mesh.vertices(f)) in_face.emplace_back(labels.label[v], kCorners);
  for (const HalfedgeId h : Mesh::halfedges(f)) {
    const EdgeId e = mesh.edge(h);
    for (std::int32_t k = 1; k < crossings.count(e); ++k) {
      const std::int32_t i = crossings.first(e).value() + k;
      in_face.emplace_back(crossings.items()[i].before, i);
    }
  }
  std::sort(in_face.begin(), in_face.end());
  for (std::size_t i = 1; i < in_face.size(); ++i) {
    if (in_face[i - 1].first == in_face[i].first) groups.unite(in_face[i - 1].second, in_face[i].second);
  }
}

}  // namespace

std::vector<EdgeId> find_disconnected_intervals(const Mesh& mesh, const NearestLabels& labels,
                                                const Crossings& crossings) {
  const std::vector<Crossing>& items = crossings.items();
  std::vector<std::int32_t> intervals;  // between a crossing and the previous one on the same edge
  for (std::int32_t i = 1; i < std::ssize(items); ++i) {
    if (items[i - 1].edge == items[i].edge) intervals.push_back(i);
  }
  std::vector<FaceId> faces;
  for (const std::int32_t i : intervals) {
    const HalfedgeId h = mesh.halfedge(items[i].edge), twin = mesh.twin(h);
    faces.push_back(Mesh::face(h));
    if (twin.valid()) faces.push_back(Mesh::face(twin));
  }
  sort_unique(faces);
  UnionFind groups(items.size());
  for (const FaceId f : faces) unite_in_face(mesh, labels, crossings, f, groups);
  std::vector<EdgeId> edges;
  for (const std::int32_t i : intervals) {
    if (groups.find(i) == kCorners) continue;
    if (edges.empty() || edges.back() != items[i].edge) edges.push_back(items[i].edge);
  }
  return edges;
}

TracedDiagram trace_connected(const WorkingMesh& working, NearestLabels labels, DiagramTracer& tracer,
                              const Progress& progress) {
  report_progress(progress, steps::kBisectors, 0);
  const Mesh& mesh = working.mesh();
  Crossings crossings = tracer.cross_edges(labels);
  std::optional<NearestLabels> labels_before;
  std::optional<Crossings> crossings_before;
  std::vector<EdgeId> crossed_once;  // ascending
  // Crosses these edges, and those of earlier calls again, at most once, between the present labels of their ends.
  const auto cross_at_most_once = [&](const std::vector<EdgeId>& edges) {
    if (edges.empty()) return;
    std::vector<EdgeId> all;
    std::set_union(edges.begin(), edges.end(), crossed_once.begin(), crossed_once.end(), std::back_inserter(all));
    crossed_once = std::move(all);
    if (!crossings_before) crossings_before = crossings;
    tracer.cross_at_most_once(crossed_once, labels, crossings);
  };
  const auto keep_labels = [&] {
    if (!labels_before) labels_before = labels;
  };
  cross_at_most_once(find_disconnected_intervals(mesh, labels, crossings));
  std::int64_t relabelled = 0;
  for (int round = 1;; ++round) {
    TracedDiagram traced{labels, crossings};
    tracer.close_faces(traced);
    CellComponents components = find_cell_components(working, traced);
    if (components.island_edges.empty()) {
      traced.cell_components = std::move(components.count);
      traced.counts.relabelled_vertices = relabelled;
      traced.labels_before = std::move(labels_before);
      traced.crossings_before = std::move(crossings_before);
      return traced;
    }
    if (round > kMaxRounds) {  // the last resort, whose cells are connected by construction
      const std::vector<EdgeId> all(mesh.edges().begin(), mesh.edges().end());
      tracer.disable_growth(all);
      keep_labels();
      relabelled += relabel_unsupported(working, labels);
      cross_at_most_once(all);
      continue;
    }
    tracer.disable_growth(components.island_edges);
    // A vertex that growth moved into an island is not relabelled, because without growth it keeps its label.
    std::vector<VertexId>& vertices = components.island_vertices;
    std::erase_if(vertices, [&](VertexId v) { return labels.label[v] != traced.labels.label[v]; });
    if (!vertices.empty()) keep_labels();
    relabelled += std::ssize(vertices);
    relabel_from_neighbours(working, vertices, labels);
    std::set<EdgeId> edges(components.island_edges.begin(), components.island_edges.end());
    for (const VertexId v : vertices) {
      for_each_neighbour(mesh, v, [&](VertexId, HalfedgeId h) { edges.insert(mesh.edge(h)); });
    }
    cross_at_most_once({edges.begin(), edges.end()});
  }
}

}  // namespace gvd
