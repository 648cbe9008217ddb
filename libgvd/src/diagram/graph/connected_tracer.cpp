#include "diagram/graph/connected_tracer.hpp"

#include <algorithm>
#include <iterator>
#include <set>

#include "diagram/graph/cell_components.hpp"
#include "diagram/graph/disconnected_intervals.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

/// Rounds of local repair before the last resort; on the meshes of docs/notes/performance.md one or two are taken.
constexpr int kMaxRounds = 12;

}  // namespace

TracedDiagram ConnectedTracer::run(DiagramReport& report) {
  report_progress(progress_, "bisectors", 0);
  crossings_ = cross_edges();
  recross_at_most_once(find_disconnected_intervals(mesh_, labels_, crossings_));
  while (true) {
    TracedDiagram traced{labels_, crossings_, {}, {}, {}};
    close_faces(traced, report);
    if (join_islands(traced)) continue;
    report.relabelled_vertices = relabelled_;
    return traced;
  }
}

/// Crosses these edges and those that were plain before at most once, between the present labels of their ends.
void ConnectedTracer::recross_at_most_once(const std::vector<EdgeId>& edges) {
  if (edges.empty()) return;
  std::vector<EdgeId> all;
  std::set_union(edges.begin(), edges.end(), plain_.begin(), plain_.end(), std::back_inserter(all));
  plain_ = std::move(all);
  cross_at_most_once(plain_, crossings_);
}

/// A vertex or a run inside an edge may hang together with no part of its cell. Then growth gives way there, such
/// vertices take the label of a neighbour, and the edges there are crossed plainly. False where there is no island.
bool ConnectedTracer::join_islands(TracedDiagram& traced) {
  CellComponents parts(working_, traced);
  traced.cell_components = parts.count_components();
  const std::vector<EdgeId> islands = parts.island_edges();
  if (islands.empty()) return false;
  if (++rounds_ > kMaxRounds) {
    connect_everywhere();
    return true;
  }
  disable_growth(islands);
  std::vector<VertexId> stranded = parts.island_vertices();
  std::erase_if(stranded, [&](VertexId v) { return labels_.label[v] != traced.labels.label[v]; });  // growth moved it
  relabelled_ += static_cast<std::int64_t>(stranded.size());
  relabel_from_neighbours(working_, stranded, labels_);
  std::set<EdgeId> edges(islands.begin(), islands.end());
  for (const VertexId v : stranded) {
    for_each_neighbour(mesh_, v, [&](VertexId, HalfedgeId h) { edges.insert(mesh_.edge(h)); });
  }
  recross_at_most_once({edges.begin(), edges.end()});
  return true;
}

/// The last resort, whose cells are connected by construction: every vertex joined to its generator by edges, and every
/// edge near a bisector crossed at most once.
void ConnectedTracer::connect_everywhere() {
  disable_growth_everywhere();
  relabelled_ += relabel_unsupported(working_, labels_);
  std::vector<EdgeId> all;
  for (std::int32_t e = 0; e < mesh_.edge_count(); ++e) all.push_back(EdgeId(e));
  recross_at_most_once(all);
}

}  // namespace gvd
