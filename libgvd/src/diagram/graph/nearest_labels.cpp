// The nearest generator of every vertex, and new labels where cells have to be connected.
//
// Distances grow along a shortest path, so that most vertices have a neighbour of the same label that is nearer to the
// generator: such a neighbour supports them. A chain of supported vertices along edges ends at the generator's vertex,
// which is why only unsupported vertices need a look when the components of cells are found. New labels come from
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

class Labeller {
 public:
  Labeller(const WorkingMesh& working, NearestLabels& labels)
      : working_(working), mesh_(working.mesh()), result_(labels) {}

  bool supports(VertexId u, VertexId v) const {
    return result_.label[u] == result_.label[v] && result_.distance[u] < result_.distance[v];
  }

  bool is_supported(VertexId v) const {
    if (working_.generator(v) == result_.label[v]) return true;
    return any_neighbour(mesh_, v, [&](VertexId u) { return supports(u, v); });
  }

  /// The unsupported vertices of a chunk. `is_surely_supported(v)` is a quick test: true only if v is supported.
  template <class Sure>
  std::vector<VertexId> find_unsupported(const Chunk& chunk, Sure is_surely_supported) const {
    std::vector<VertexId> unsupported;
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const VertexId v(i);
      if (result_.label[v].valid() && !is_surely_supported(v) && !is_supported(v)) unsupported.push_back(v);
    }
    return unsupported;
  }

  void clear(VertexId v) {
    result_.label[v] = GeneratorId();
    result_.distance[v] = kInfinity;
  }

  /// Clears the label of every vertex that no chain of supported vertices connects to its generator; returns them.
  std::vector<VertexId> clear_unsupported() {
    std::vector<VertexId> cleared, suspects;
    const auto examine = [&](VertexId v) {
      if (!result_.label[v].valid() || is_supported(v)) return;
      clear(v);
      cleared.push_back(v);
      for_each_neighbour(mesh_, v, [&](VertexId u, HalfedgeId) { suspects.push_back(u); });
    };
    for (const VertexId v : mesh_.vertices()) examine(v);
    while (!suspects.empty()) {
      const VertexId v = suspects.back();
      suspects.pop_back();
      examine(v);
    }
    return cleared;
  }

  /// Labels these vertices from their labelled neighbours, by Dijkstra's algorithm along the edges.
  void label_from_neighbours(const std::vector<VertexId>& cleared) {
    using Offer = std::tuple<double, GeneratorId, VertexId>;
    std::priority_queue<Offer, std::vector<Offer>, std::greater<>> offers;
    const auto offer = [&](VertexId to, VertexId from, double length) {
      const GeneratorId g = result_.label[from];
      if (g.valid() && !result_.label[to].valid()) offers.emplace(result_.distance[from] + length, g, to);
    };
    for (const VertexId v : cleared) {
      for_each_neighbour(mesh_, v, [&](VertexId u, HalfedgeId h) { offer(v, u, mesh_.length(h)); });
    }
    while (!offers.empty()) {
      const auto [distance, g, v] = offers.top();
      offers.pop();
      if (result_.label[v].valid()) continue;
      result_.label[v] = g;
      result_.distance[v] = distance;
      for_each_neighbour(mesh_, v, [&, from = v](VertexId u, HalfedgeId h) { offer(u, from, mesh_.length(h)); });
    }
  }

 private:
  const WorkingMesh& working_;
  const Mesh& mesh_;
  NearestLabels& result_;
};

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
  const Labeller labeller(working, labels);
  labels.unsupported = labeller.find_unsupported({0, labels.label.size()}, [&](VertexId v) {
    // In most cases one of the two corners that the distance was computed from has the same label.
    const HalfedgeId via = table.distance(v.value()).via;
    return via.valid() && (labeller.supports(mesh.from(via), v) || labeller.supports(mesh.to(via), v));
  });
  return labels;
}

NearestLabels take_labels(const WorkingMesh& working, const IdVector<VertexId, double>& distance,
                          const IdVector<VertexId, GeneratorId>& label, const ParallelChunks& parallel) {
  NearestLabels labels{label, distance, {}};
  const Labeller labeller(working, labels);
  labels.unsupported = parallel.collect(
      cut_into_chunks(label.size(), kScanChunk), steps::kLabels,
      [&](const Chunk& chunk) { return labeller.find_unsupported(chunk, [](VertexId) { return false; }); });
  return labels;
}

NearestLabels take_labels(const WorkingMesh& working, const IdVector<VertexId, double>& distance,
                          const IdVector<VertexId, GeneratorId>& label, const std::vector<VertexId>& known,
                          const std::vector<VertexId>& changed) {
  NearestLabels labels{label, distance, {}};
  const Labeller labeller(working, labels);
  std::vector<VertexId> found, kept;
  std::ranges::copy_if(changed, std::back_inserter(found),
                       [&](VertexId v) { return label[v].valid() && !labeller.is_supported(v); });
  std::ranges::set_difference(known, changed, std::back_inserter(kept));
  std::ranges::merge(kept, found, std::back_inserter(labels.unsupported));
  return labels;
}

void relabel_from_neighbours(const WorkingMesh& working, const std::vector<VertexId>& vertices, NearestLabels& labels) {
  Labeller labeller(working, labels);
  for (const VertexId v : vertices) labeller.clear(v);
  labeller.label_from_neighbours(vertices);
  // They may have been what supported their neighbours.
  const auto examine = [&](VertexId v) {
    if (labels.label[v].valid() && !labeller.is_supported(v)) labels.unsupported.push_back(v);
  };
  for (const VertexId v : vertices) {
    examine(v);
    for_each_neighbour(working.mesh(), v, [&](VertexId u, HalfedgeId) { examine(u); });
  }
}

std::int64_t relabel_unsupported(const WorkingMesh& working, NearestLabels& labels) {
  Labeller labeller(working, labels);
  const std::vector<VertexId> cleared = labeller.clear_unsupported();
  labeller.label_from_neighbours(cleared);
  labels.unsupported.clear();
  return std::ssize(cleared);
}

}  // namespace gvd
