#include "diagram/nearest_labels.hpp"

#include <algorithm>
#include <limits>
#include <queue>
#include <tuple>
#include <vector>

#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

class Labeller {
 public:
  Labeller(const WorkingMesh& working, const GeneratorTable& table, NearestLabels& labels)
      : working_(working), mesh_(working.mesh()), table_(table), result_(labels) {}

  void take_nearest() {
    const auto n = static_cast<std::size_t>(mesh_.vertex_count());
    result_.label.resize(n);
    result_.distance.assign(n, kInfinity);
    for (std::int32_t i = 0; i < mesh_.vertex_count(); ++i) {
      const VertexId v(i);
      table_.for_each(v, [&](const VertexDistance& d) {
        if (std::tuple(d.distance, d.generator) < std::tuple(result_.distance[v], result_.label[v]) ||
            !result_.label[v].valid()) {
          result_.distance[v] = d.distance;
          result_.label[v] = d.generator;
        }
      });
    }
  }

  void list_unsupported() {
    for (std::int32_t i = 0; i < mesh_.vertex_count(); ++i) {
      if (result_.label[VertexId(i)].valid() && !is_supported(VertexId(i))) result_.unsupported.push_back(VertexId(i));
    }
  }

  void strip(VertexId v) {
    result_.label[v] = GeneratorId();
    result_.distance[v] = kInfinity;
  }

  /// Strips the label of every vertex that no chain joins to its generator; returns them.
  std::vector<VertexId> take_away_unsupported() {
    std::vector<VertexId> orphans, suspects;
    const auto examine = [&](VertexId v) {
      if (!result_.label[v].valid() || is_supported(v)) return;
      strip(v);
      orphans.push_back(v);
      for_each_neighbour(mesh_, v, [&](VertexId u, HalfedgeId) { suspects.push_back(u); });
    };
    for (std::int32_t i = 0; i < mesh_.vertex_count(); ++i) examine(VertexId(i));
    while (!suspects.empty()) {
      const VertexId v = suspects.back();
      suspects.pop_back();
      examine(v);
    }
    return orphans;
  }

  /// Gives every orphan a label that one of its neighbours has, nearest first: Dijkstra from the labelled neighbours.
  void adopt(const std::vector<VertexId>& orphans) {
    using Offer = std::tuple<double, GeneratorId, VertexId>;
    std::priority_queue<Offer, std::vector<Offer>, std::greater<>> offers;
    const auto offer = [&](VertexId to, VertexId from, double length) {
      const GeneratorId g = result_.label[from];
      if (!g.valid() || result_.label[to].valid()) return;
      // The distance that the march found, where it found one; never at or below the supporting neighbour's.
      const double along_edge = result_.distance[from] + length;
      const std::int32_t place = table_.find(to, g);
      const double known = place >= 0 ? table_.distance(place).distance : kInfinity;
      offers.emplace(known > result_.distance[from] ? std::min(known, along_edge) : along_edge, g, to);
    };
    for (const VertexId v : orphans) {
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
  bool is_generator_of(VertexId v, GeneratorId g) const { return working_.vertex(g) == v; }

  bool supports(VertexId u, VertexId v) const {
    return result_.label[u] == result_.label[v] && result_.distance[u] < result_.distance[v];
  }

  bool is_supported(VertexId v) const {
    if (is_generator_of(v, result_.label[v])) return true;
    // Mostly one of the two corners that the distance came from has the same label.
    const HalfedgeId via = table_.distance(v.value()).via;
    if (via.valid() && (supports(mesh_.from(via), v) || supports(mesh_.to(via), v))) return true;
    bool supported = false;
    for_each_neighbour(mesh_, v, [&](VertexId u, HalfedgeId) {
      supported = supported || supports(u, v);
    });
    return supported;
  }

  const WorkingMesh& working_;
  const Mesh& mesh_;
  const GeneratorTable& table_;
  NearestLabels& result_;
};

}  // namespace

NearestLabels compute_nearest_labels(const WorkingMesh& working, const GeneratorTable& table) {
  NearestLabels labels;
  Labeller labeller(working, table, labels);
  labeller.take_nearest();
  labeller.list_unsupported();
  return labels;
}

NearestLabels take_labels(const WorkingMesh& working, const IdVector<VertexId, double>& distance,
                          const IdVector<VertexId, std::int32_t>& label) {
  NearestLabels labels;
  labels.distance = distance;
  for (const std::int32_t g : label.raw()) labels.label.push_back(g < 0 ? GeneratorId() : GeneratorId(g));
  const Mesh& mesh = working.mesh();
  for (std::int32_t i = 0; i < mesh.vertex_count(); ++i) {
    const VertexId v(i);
    if (!labels.label[v].valid() || working.generator(v) == labels.label[v]) continue;
    bool supported = false;
    for_each_neighbour(mesh, v, [&](VertexId u, HalfedgeId) {
      supported = supported || (labels.label[u] == labels.label[v] && labels.distance[u] < labels.distance[v]);
    });
    if (!supported) labels.unsupported.push_back(v);
  }
  return labels;
}

void relabel_from_neighbours(const WorkingMesh& working, const GeneratorTable& table, const std::vector<VertexId>& vertices,
                             NearestLabels& labels) {
  Labeller labeller(working, table, labels);
  for (const VertexId v : vertices) labeller.strip(v);
  labeller.adopt(vertices);
}

std::int64_t relabel_unsupported(const WorkingMesh& working, const GeneratorTable& table, NearestLabels& labels) {
  Labeller labeller(working, table, labels);
  const std::vector<VertexId> orphans = labeller.take_away_unsupported();
  labeller.adopt(orphans);
  labels.unsupported.clear();
  return static_cast<std::int64_t>(orphans.size());
}

}  // namespace gvd
