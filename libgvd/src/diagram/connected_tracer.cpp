#include "diagram/connected_tracer.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

#include "diagram/graph/cell_components.hpp"
#include "diagram/graph/disconnected_intervals.hpp"
#include "gvd/diagram_steps.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

/// Rounds of local repair before the last resort; the meshes of docs/developer/performance.md take one or two.
constexpr int kMaxRounds = 12;

class ConnectedTracer {
 public:
  ConnectedTracer(const WorkingMesh& working, NearestLabels labels, const TracerSteps& steps)
      : working_(working), mesh_(working.mesh()), steps_(steps), labels_(std::move(labels)) {}

  TracedDiagram run() {
    crossings_ = steps_.cross_edges(labels_);
    cross_at_most_once(find_disconnected_intervals(mesh_, labels_, crossings_));
    while (true) {
      TracedDiagram traced{labels_, crossings_};
      steps_.close_faces(traced);
      CellComponents components(working_, traced);
      traced.cell_components = components.count_components();
      traced.counts.relabelled_vertices = relabelled_;
      const std::vector<EdgeId> islands = components.island_edges();
      if (islands.empty()) {
        traced.before_relabelling = std::move(before_relabelling_);
        return traced;
      }
      if (++rounds_ > kMaxRounds) {
        connect_everywhere();
      } else {
        connect(islands, vertices_to_relabel(components, traced));
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
    steps_.cross_at_most_once(crossed_once_, labels_, crossings_);
  }

  /// The vertices of islands, without those that are there because growth moved them.
  std::vector<VertexId> vertices_to_relabel(CellComponents& components, const TracedDiagram& traced) const {
    std::vector<VertexId> relabelled = components.island_vertices();
    std::erase_if(relabelled, [&](VertexId v) { return labels_.label[v] != traced.labels.label[v]; });
    return relabelled;
  }

  /// Prepares the next round: no growth around the islands, new labels for their vertices, one crossing at most on
  /// their edges.
  void connect(const std::vector<EdgeId>& islands, const std::vector<VertexId>& relabelled) {
    steps_.disable_growth(islands);
    relabelled_ += static_cast<std::int64_t>(relabelled.size());
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
    std::vector<EdgeId> all;
    for (std::int32_t e = 0; e < mesh_.edge_count(); ++e) all.push_back(EdgeId(e));
    steps_.disable_growth(all);
    keep_labels();
    relabelled_ += relabel_unsupported(working_, labels_);
    cross_at_most_once(all);
  }

  void keep_labels() {
    if (!before_relabelling_) before_relabelling_ = labels_;
  }

  const WorkingMesh& working_;
  const Mesh& mesh_;
  const TracerSteps& steps_;
  NearestLabels labels_;
  std::optional<NearestLabels> before_relabelling_;
  Crossings crossings_;
  std::vector<EdgeId> crossed_once_;  // ascending
  std::int64_t relabelled_ = 0;
  int rounds_ = 0;
};

}  // namespace

TracedDiagram trace_connected(const WorkingMesh& working, NearestLabels labels, const TracerSteps& steps,
                              const Progress& progress) {
  report_progress(progress, steps::kBisectors, 0);
  return ConnectedTracer(working, std::move(labels), steps).run();
}

}  // namespace gvd
