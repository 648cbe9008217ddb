#include "diagram/growth/gap_labels.hpp"

#include <algorithm>
#include <cstddef>
#include <tuple>

namespace gvd {
namespace {

/// A vertex of the gap as an end of one of its edges.
struct EdgeAtVertex {
  VertexId vertex;
  std::size_t edge;  // index of the edge in the gap
};

class GapLabels {
 public:
  GapLabels(const WorkingMesh& working, const NearestLabels& labels, const std::vector<GapEdge>& edges)
      : working_(working), mesh_(working.mesh()), labels_(labels), edges_(edges) {
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      const HalfedgeId h = mesh_.halfedge(edges_[i].edge);
      edges_of_.push_back({mesh_.from(h), i});
      edges_of_.push_back({mesh_.to(h), i});
    }
    std::sort(edges_of_.begin(), edges_of_.end(),
              [](const auto& a, const auto& b) { return std::tuple(a.vertex, a.edge) < std::tuple(b.vertex, b.edge); });
    label_.resize(edges_of_.size());
  }

  /// Spreads the labels from the rim and the generators along the gap's edges.
  void spread() {
    for (const EdgeAtVertex& e : edges_of_) {
      if (edges_[e.edge].rim || working_.generator(e.vertex).valid()) set_label(e.vertex, labels_.label[e.vertex]);
    }
    for (std::size_t k = 0; k < labelled_.size(); ++k) spread_from(labelled_[k]);
  }

  bool are_complete_and_agree() const {
    for (std::size_t i = 0; i < edges_of_.size(); ++i) {
      if (is_first_of_vertex(i) && !label_[i].valid()) return false;
    }
    return std::all_of(edges_.begin(), edges_.end(), [&](const GapEdge& e) {
      const HalfedgeId h = mesh_.halfedge(e.edge);
      const GeneratorId from = label_[index_of(mesh_.from(h))], to = label_[index_of(mesh_.to(h))];
      if (e.crossings.empty()) return from == to;
      return e.crossings.front().before == from && e.crossings.back().after == to;
    });
  }

  std::vector<std::pair<VertexId, GeneratorId>> moved() const {
    std::vector<std::pair<VertexId, GeneratorId>> moved;
    for (std::size_t i = 0; i < edges_of_.size(); ++i) {
      const VertexId v = edges_of_[i].vertex;
      if (is_first_of_vertex(i) && labels_.label[v] != label_[i]) moved.emplace_back(v, label_[i]);
    }
    return moved;
  }

 private:
  bool is_first_of_vertex(std::size_t i) const { return i == 0 || edges_of_[i].vertex != edges_of_[i - 1].vertex; }

  /// The first index of v in edges_of_; label_ holds its label there.
  std::size_t index_of(VertexId v) const {
    const auto it = std::lower_bound(edges_of_.begin(), edges_of_.end(), v,
                                     [](const EdgeAtVertex& e, VertexId value) { return e.vertex < value; });
    return static_cast<std::size_t>(it - edges_of_.begin());
  }

  void set_label(VertexId v, GeneratorId g) {
    const std::size_t i = index_of(v);
    if (label_[i].valid()) return;
    label_[i] = g;
    labelled_.push_back(i);
  }

  /// Labels the neighbours of the vertex whose first index is `first`.
  void spread_from(std::size_t first) {
    const VertexId v = edges_of_[first].vertex;
    for (std::size_t i = first; i < edges_of_.size() && edges_of_[i].vertex == v; ++i) {
      const GapEdge& e = edges_[edges_of_[i].edge];
      const HalfedgeId h = mesh_.halfedge(e.edge);
      const bool forwards = mesh_.from(h) == v;
      const VertexId other = forwards ? mesh_.to(h) : mesh_.from(h);
      if (e.crossings.empty()) {
        set_label(other, label_[first]);
      } else {
        set_label(other, forwards ? e.crossings.back().after : e.crossings.front().before);
      }
    }
  }

  const WorkingMesh& working_;
  const Mesh& mesh_;
  const NearestLabels& labels_;
  const std::vector<GapEdge>& edges_;
  std::vector<EdgeAtVertex> edges_of_;  // ascending by (vertex, edge)
  std::vector<GeneratorId> label_;      // of the vertex whose first index this is; invalid elsewhere
  std::vector<std::size_t> labelled_;   // first indices of the labelled vertices, in the order of labelling
};

}  // namespace

std::optional<std::vector<std::pair<VertexId, GeneratorId>>> find_moved_labels(const WorkingMesh& working,
                                                                               const NearestLabels& labels,
                                                                               const GapEdges& gap_edges) {
  GapLabels gap_labels(working, labels, gap_edges.edges());
  gap_labels.spread();
  if (!gap_labels.are_complete_and_agree()) return std::nullopt;
  return gap_labels.moved();
}

}  // namespace gvd
