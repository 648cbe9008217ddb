// Finds the nearest generator of every vertex, and new labels where cells must be connected.
//
// Distances grow along a shortest path, so that most vertices have a neighbour of the same label that is nearer to the
// generator: such a neighbour supports them. A chain of supported vertices along edges ends at the generator's vertex,
// so that only unsupported vertices must be examined when the components of cells are searched. New labels come from
// labelled neighbours by Dijkstra's algorithm along the edges, so that every relabelled vertex is supported.
// Source: labels and classes of faces are those of section 3 of the paper; it knows no relabelling.
// Invariant: the vertex of a generator has the label of that generator, even where offsets say otherwise.
#include "diagram/graph/nearest_labels.hpp"

#include <algorithm>
#include <iterator>
#include <queue>
#include <tuple>
#include <vector>

#include "gvd/diagram_steps.hpp"
#include "gvd/vec.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

/// Whether u supports its neighbour v.
bool supports(const NearestLabels& labels, VertexId u, VertexId v) {
  return labels.label[u] == labels.label[v] && labels.distance[u] < labels.distance[v];
}

/// Whether a labelled vertex has no support: see NearestLabels.
bool is_unsupported(const WorkingMesh& working, const NearestLabels& labels, VertexId v) {
  if (!labels.label[v].valid() || working.generator(v) == labels.label[v]) return false;
  return !any_neighbour(working.mesh(), v, [&](VertexId u) { return supports(labels, u, v); });
}

void clear_label(VertexId v, NearestLabels& labels) {
  labels.label[v] = GeneratorId();
  labels.distance[v] = kInfinity;
}

/// Labels these vertices from their labelled neighbours, by Dijkstra's algorithm along the edges.
void label_from_neighbours(const Mesh& mesh, const std::vector<VertexId>& cleared, NearestLabels& labels) {
  using Offer = std::tuple<double, GeneratorId, VertexId>;
  std::priority_queue<Offer, std::vector<Offer>, std::greater<>> offers;
  const auto offer = [&](VertexId to, VertexId from, double length) {
    const GeneratorId g = labels.label[from];
    if (g.valid() && !labels.label[to].valid()) offers.emplace(labels.distance[from] + length, g, to);
  };
  for (const VertexId v : cleared) {
    for_each_neighbour(mesh, v, [&](VertexId u, HalfedgeId h) { offer(v, u, mesh.length(h)); });
  }
  while (!offers.empty()) {
    const auto [distance, g, v] = offers.top();
    offers.pop();
    if (labels.label[v].valid()) continue;
    labels.label[v] = g;
    labels.distance[v] = distance;
    for_each_neighbour(mesh, v, [&, from = v](VertexId u, HalfedgeId h) { offer(u, from, mesh.length(h)); });
  }
}

void take_nearest(const WorkingMesh& working, const GeneratorTable& table, NearestLabels& result) {
  const Mesh& mesh = working.mesh();
  result.label.resize(mesh.vertex_count());
  result.distance.assign(mesh.vertex_count(), kInfinity);
  for (const VertexId v : mesh.vertices()) {
    table.for_each(v, [&](const VertexDistance& d) {
      if (std::tuple(d.distance, d.generator) < std::tuple(result.distance[v], result.label[v]) ||
          !result.label[v].valid()) {
        result.distance[v] = d.distance;
        result.label[v] = d.generator;
      }
    });
  }
  // A generator owns its vertex even if its symbolic offset is larger than the distance to the next generator.
  for (const GeneratorId g : working.generator_vertices().ids()) {
    const VertexId v = working.vertex(g);
    result.label[v] = g;
    result.distance[v] = table.distance(table.find(v, g)).distance;
  }
}

}  // namespace

FaceClass classify(const Mesh& mesh, const IdVector<VertexId, GeneratorId>& label, FaceId f) {
  const auto& [a, b, c] = mesh.vertices(f);
  if (!label[a].valid() || !label[b].valid() || !label[c].valid()) return FaceClass::unreached;
  const int equal = (label[a] == label[b]) + (label[b] == label[c]) + (label[c] == label[a]);
  if (equal == 3) return FaceClass::trivial;
  return equal == 1 ? FaceClass::ordinary : FaceClass::branching;
}

NearestLabels compute_nearest_labels(const WorkingMesh& working, const GeneratorTable& table) {
  const Mesh& mesh = working.mesh();
  NearestLabels labels;
  take_nearest(working, table, labels);
  for (const VertexId v : mesh.vertices()) {
    if (!labels.label[v].valid()) continue;
    // In most cases, one of the two corners from which the distance was computed has the same label.
    const HalfedgeId via = table.distance(v.value()).via;
    const bool is_supported = via.valid() && (supports(labels, mesh.from(via), v) || supports(labels, mesh.to(via), v));
    if (!is_supported && is_unsupported(working, labels, v)) labels.unsupported.push_back(v);
  }
  return labels;
}

NearestLabels take_labels(const WorkingMesh& working, const IdVector<VertexId, double>& distance,
                          const IdVector<VertexId, GeneratorId>& label, const ParallelChunks& parallel) {
  NearestLabels labels{label, distance, {}};
  const auto chunks = cut_into_chunks(label.size(), kScanChunk);
  labels.unsupported = parallel.collect(chunks, steps::kLabels, [&](const Chunk& chunk) {
    std::vector<VertexId> unsupported;
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      if (is_unsupported(working, labels, VertexId(i))) unsupported.emplace_back(i);
    }
    return unsupported;
  });
  return labels;
}

NearestLabels take_labels(const WorkingMesh& working, const IdVector<VertexId, double>& distance,
                          const IdVector<VertexId, GeneratorId>& label, const std::vector<VertexId>& known,
                          const std::vector<VertexId>& changed) {
  NearestLabels labels{label, distance, {}};
  std::vector<VertexId> found, kept;
  std::ranges::copy_if(changed, std::back_inserter(found),
                       [&](VertexId v) { return is_unsupported(working, labels, v); });
  std::ranges::set_difference(known, changed, std::back_inserter(kept));
  std::ranges::merge(kept, found, std::back_inserter(labels.unsupported));
  return labels;
}

void relabel_from_neighbours(const WorkingMesh& working, const std::vector<VertexId>& vertices, NearestLabels& labels) {
  for (const VertexId v : vertices) clear_label(v, labels);
  label_from_neighbours(working.mesh(), vertices, labels);
  // The relabelled vertices may have supported their neighbours.
  const auto examine = [&](VertexId v) {
    if (is_unsupported(working, labels, v)) labels.unsupported.push_back(v);
  };
  for (const VertexId v : vertices) {
    examine(v);
    for_each_neighbour(working.mesh(), v, [&](VertexId u, HalfedgeId) { examine(u); });
  }
}

std::int64_t relabel_unsupported(const WorkingMesh& working, NearestLabels& labels) {
  const Mesh& mesh = working.mesh();
  std::vector<VertexId> cleared, suspects;
  const auto examine = [&](VertexId v) {
    if (!is_unsupported(working, labels, v)) return;
    clear_label(v, labels);
    cleared.push_back(v);
    for_each_neighbour(mesh, v, [&](VertexId u, HalfedgeId) { suspects.push_back(u); });
  };
  for (const VertexId v : mesh.vertices()) examine(v);
  while (!suspects.empty()) {
    const VertexId v = suspects.back();
    suspects.pop_back();
    examine(v);
  }
  label_from_neighbours(mesh, cleared, labels);
  labels.unsupported.clear();
  return std::ssize(cleared);
}

}  // namespace gvd
