// The rounds that connect every cell, around any tracer.
//
// The edges are crossed and the faces closed; then every piece of a cell has to be connected to the cell's generator.
// Around a piece that is not, growth is disabled, vertices take the label of a neighbour, edges are crossed at most
// once, and the faces are closed again. After a fixed number of rounds all edges are crossed at most once, between
// labels that edges join to their generators: such cells are connected by construction.
//
// Source: the paper does not treat this; see docs/developer/algorithm.md.
#include "diagram/graph/connected_tracer.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

#include "base/union_find.hpp"
#include "gvd/diagram_steps.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

/// Rounds of local repair before the last resort; the meshes of docs/developer/performance.md take one or two.
constexpr int kMaxRounds = 12;

/// The label intervals inside of edges, in groups that common faces connect. An interval is known by the index of the
/// crossing at its end.
class IntervalGroups {
 public:
  IntervalGroups(const Mesh& mesh, const NearestLabels& labels, const Crossings& crossings)
      : mesh_(mesh), labels_(labels), crossings_(crossings), items_(crossings.items()), groups_(items_.size()) {
    std::vector<FaceId> faces;
    for (int i = 1; i < std::ssize(items_); ++i) {
      if (!is_interval(i)) continue;
      const HalfedgeId h = mesh_.halfedge(items_[i].edge), twin = mesh_.twin(h);
      faces.push_back(Mesh::face(h));
      if (twin.valid()) faces.push_back(Mesh::face(twin));
    }
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    for (const FaceId f : faces) join_in_face(f);
  }

  /// Whether interval i exists, and no common faces connect it to a corner.
  bool is_disconnected(std::int32_t i) { return is_interval(i) && groups_.find(i) != kCorners; }

 private:
  /// Represents all corners: no interval has index 0.
  static constexpr std::int32_t kCorners = 0;

  /// Whether crossings i - 1 and i bound an interval.
  bool is_interval(std::int32_t i) const { return items_[i - 1].edge == items_[i].edge; }

  void join_in_face(FaceId f) {
    in_face_.clear();
    for (const VertexId v : mesh_.vertices(f)) in_face_.emplace_back(labels_.label[v], kCorners);
    for (int corner = 0; corner < 3; ++corner) {
      const EdgeId e = mesh_.edge(Mesh::halfedge(f, corner));
      if (!crossings_.first(e).valid()) continue;
      for (int k = crossings_.first(e).value() + 1; k < std::ssize(items_) && items_[k].edge == e; ++k) {
        in_face_.emplace_back(items_[k].before, k);
      }
    }
    std::sort(in_face_.begin(), in_face_.end());
    for (std::size_t i = 1; i < in_face_.size(); ++i) {
      if (in_face_[i - 1].first == in_face_[i].first) groups_.unite(in_face_[i - 1].second, in_face_[i].second);
    }
  }

  const Mesh& mesh_;
  const NearestLabels& labels_;
  const Crossings& crossings_;
  const std::vector<Crossing>& items_;
  UnionFind groups_;                                           // of intervals, and kCorners
  std::vector<std::pair<GeneratorId, std::int32_t>> in_face_;  // labels and intervals of the current face
};

class ConnectedTracer {
 public:
  ConnectedTracer(const WorkingMesh& working, NearestLabels labels, DiagramTracer& tracer)
      : working_(working), mesh_(working.mesh()), tracer_(tracer), labels_(std::move(labels)) {}

  TracedDiagram run() {
    crossings_ = tracer_.cross_edges(labels_);
    cross_at_most_once(find_disconnected_intervals(mesh_, labels_, crossings_));
    while (true) {
      TracedDiagram traced{labels_, crossings_};
      tracer_.close_faces(traced);
      const CellComponents components = find_cell_components(working_, traced);
      traced.cell_components = components.count;
      traced.counts.relabelled_vertices = relabelled_;
      if (components.island_edges.empty()) {
        traced.before_relabelling = std::move(before_relabelling_);
        return traced;
      }
      if (++rounds_ > kMaxRounds) {
        connect_everywhere();
      } else {
        connect(components.island_edges, vertices_to_relabel(components, traced));
      }
    }
  }

 private:
  /// Crosses these edges at most once, between the present labels of their ends; those of earlier calls again.
  void cross_at_most_once(const std::vector<EdgeId>& edges) {
    if (edges.empty()) return;
    std::vector<EdgeId> all;
    std::set_union(edges.begin(), edges.end(), crossed_once_.begin(), crossed_once_.end(), std::back_inserter(all));
    crossed_once_ = std::move(all);
    tracer_.cross_at_most_once(crossed_once_, labels_, crossings_);
  }

  /// The vertices of islands, without those that are there because growth moved them.
  std::vector<VertexId> vertices_to_relabel(const CellComponents& components, const TracedDiagram& traced) const {
    std::vector<VertexId> relabelled = components.island_vertices;
    std::erase_if(relabelled, [&](VertexId v) { return labels_.label[v] != traced.labels.label[v]; });
    return relabelled;
  }

  /// Prepares the next round: no growth around the islands, new labels for their vertices, one crossing at most on
  /// their edges.
  void connect(const std::vector<EdgeId>& islands, const std::vector<VertexId>& relabelled) {
    tracer_.disable_growth(islands);
    relabelled_ += std::ssize(relabelled);
    if (!relabelled.empty()) keep_labels();
    relabel_from_neighbours(working_, relabelled, labels_);
    std::set<EdgeId> edges(islands.begin(), islands.end());
    for (const VertexId v : relabelled) {
      for_each_neighbour(mesh_, v, [&](VertexId, HalfedgeId h) { edges.insert(mesh_.edge(h)); });
    }
    cross_at_most_once({edges.begin(), edges.end()});
  }

  /// The last resort, whose cells are connected by construction.
  void connect_everywhere() {
    const std::vector<EdgeId> all(mesh_.edges().begin(), mesh_.edges().end());
    tracer_.disable_growth(all);
    keep_labels();
    relabelled_ += relabel_unsupported(working_, labels_);
    cross_at_most_once(all);
  }

  void keep_labels() {
    if (!before_relabelling_) before_relabelling_ = labels_;
  }

  const WorkingMesh& working_;
  const Mesh& mesh_;
  DiagramTracer& tracer_;
  NearestLabels labels_;
  std::optional<NearestLabels> before_relabelling_;
  Crossings crossings_;
  std::vector<EdgeId> crossed_once_;  // ascending
  std::int64_t relabelled_ = 0;
  int rounds_ = 0;
};

}  // namespace

std::vector<EdgeId> find_disconnected_intervals(const Mesh& mesh, const NearestLabels& labels,
                                                const Crossings& crossings) {
  IntervalGroups groups(mesh, labels, crossings);
  const auto& items = crossings.items();
  std::vector<EdgeId> edges;
  for (int i = 1; i < std::ssize(items); ++i) {
    if (!groups.is_disconnected(i)) continue;
    if (edges.empty() || edges.back() != items[i].edge) edges.push_back(items[i].edge);
  }
  return edges;
}

TracedDiagram trace_connected(const WorkingMesh& working, NearestLabels labels, DiagramTracer& tracer,
                              const Progress& progress) {
  report_progress(progress, steps::kBisectors, 0);
  return ConnectedTracer(working, std::move(labels), tracer).run();
}

}  // namespace gvd
