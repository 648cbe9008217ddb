#include "diagram/trace_diagram.hpp"

#include <algorithm>
#include <iterator>
#include <set>

#include "diagram/assemble_faces.hpp"
#include "diagram/cell_topology.hpp"
#include "diagram/growth.hpp"
#include "diagram/install_gaps.hpp"
#include "diagram/refine_bisectors.hpp"
#include "diagram/rough_bisectors.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

/// Rounds of local repair before the last resort; on the meshes of docs/performance.md one or two are taken.
constexpr int kMaxRounds = 12;

class Tracer {
 public:
  Tracer(const WorkingMesh& working, const GeneratorTable& table, const DiagramOptions& options)
      : working_(working),
        mesh_(working.mesh()),
        table_(table),
        front_(options.front),
        progress_(options.progress),
        labels_(compute_nearest_labels(working, table)),
        rough_(find_rough_crossings(working, table, labels_, front_)),
        gaps_(find_gaps(mesh_, table)),
        may_grow_(gaps_.size(), 1) {
    recross_plainly(find_lonely_runs(mesh_, labels_, rough_));
  }

  TracedDiagram run(DiagramReport& report) {
    report.gaps = static_cast<std::int64_t>(gaps_.size());
    while (true) {
      TracedDiagram traced{labels_, rough_, {}, {}, {}};
      refine(traced.crossings);
      report_progress(progress_, "growth", 0);
      report.gaps_grown = grow(traced);
      report.gaps_assembled = report.gaps - report.gaps_grown;
      report_progress(progress_, "bisectors", 0.5);
      assemble_rest(traced);
      if (give_way_to_islands(traced)) continue;
      report.relabelled_samples = relabelled_;
      return traced;
    }
  }

 private:
  /// Crosses these edges and those that were plain before at most once, between the present labels of their ends.
  void recross_plainly(const std::vector<EdgeId>& edges) {
    std::vector<EdgeId> all;
    std::set_union(edges.begin(), edges.end(), plain_.begin(), plain_.end(), std::back_inserter(all));
    plain_ = std::move(all);
    cross_plainly(working_, table_, labels_, front_, plain_, rough_);
  }

  /// With planar fronts the rough crossings interpolate distances, and unfolding makes them better. With circles they
  /// come from sources that were unfolded over the very edge, the same for both of its faces: there is nothing to
  /// refine or weld, and images unfolded over other edges would make them worse (docs/performance.md has the figures).
  void refine(Crossings& crossings) const {
    if (front_ == Front::circle) return;
    weld_crossings(refine_bisectors(working_, table_, labels_, crossings), crossings);
  }

  /// Grows every gap that may; returns how many closed.
  std::int64_t grow(TracedDiagram& traced) {
    std::vector<ClosedGap> closed;
    for (std::size_t i = 0; i < gaps_.size(); ++i) {
      if (!may_grow_[i]) continue;
      auto grown = grow_gap(working_, table_, traced.labels, traced.crossings, gaps_[i]);
      if (grown) closed.push_back({&gaps_[i], std::move(*grown)});
      may_grow_[i] = grown.has_value();
    }
    install_grown_gaps(mesh_, closed, traced);
    return static_cast<std::int64_t>(closed.size());
  }

  /// Assembles the faces outside of grown gaps, and puts all arcs in the order of their faces.
  void assemble_rest(TracedDiagram& traced) {
    std::vector<FaceId> grown;
    for (std::size_t i = 0; i < gaps_.size(); ++i) {
      if (may_grow_[i]) grown.insert(grown.end(), gaps_[i].faces.begin(), gaps_[i].faces.end());
    }
    std::sort(grown.begin(), grown.end());
    assemble_faces(working_, table_, traced.labels, traced.crossings, front_, grown, traced.faces);
    std::stable_sort(traced.faces.arcs.begin(), traced.faces.arcs.end(),
                     [](const FaceArc& a, const FaceArc& b) { return a.face < b.face; });
  }

  /// A vertex or a run inside an edge may hang together with no part of its cell. Then the gaps there are assembled,
  /// such vertices take the label of a neighbour, and the edges there are crossed plainly, between the labels of their
  /// ends. False where there is no island.
  bool give_way_to_islands(TracedDiagram& traced) {
    CellParts parts(working_, traced);
    traced.cell_components = parts.count_components();
    const std::vector<EdgeId> islands = parts.island_edges();
    if (islands.empty()) return false;
    if (++rounds_ > kMaxRounds) {
      give_way_everywhere();
      return true;
    }
    for (std::size_t i = 0; i < gaps_.size(); ++i) {
      if (may_grow_[i] && touches(gaps_[i], islands)) may_grow_[i] = 0;
    }
    std::vector<VertexId> stranded = parts.island_vertices();
    std::erase_if(stranded, [&](VertexId v) { return labels_.label[v] != traced.labels.label[v]; });  // growth moved it
    relabelled_ += static_cast<std::int64_t>(stranded.size());
    relabel_from_neighbours(working_, table_, stranded, labels_);
    std::set<EdgeId> edges(islands.begin(), islands.end());
    for (const VertexId v : stranded) {
      for_each_neighbour(mesh_, v, [&](VertexId, HalfedgeId h) { edges.insert(mesh_.edge(h)); });
    }
    recross_plainly({edges.begin(), edges.end()});
    return true;
  }

  /// The last resort, whose cells are connected by construction: no growth, every vertex joined to its generator by
  /// edges, and every edge near a bisector crossed at most once.
  void give_way_everywhere() {
    std::fill(may_grow_.begin(), may_grow_.end(), 0);
    relabelled_ += relabel_unsupported(working_, table_, labels_);
    std::vector<EdgeId> all;
    for (std::int32_t e = 0; e < mesh_.edge_count(); ++e) all.push_back(EdgeId(e));
    recross_plainly(all);
  }

  bool touches(const Gap& gap, const std::vector<EdgeId>& edges) const {
    return std::any_of(edges.begin(), edges.end(), [&](EdgeId e) {
      const HalfedgeId h = mesh_.halfedge(e), twin = mesh_.twin(h);
      return gap.contains(Mesh::face(h)) || (twin.valid() && gap.contains(Mesh::face(twin)));
    });
  }

  const WorkingMesh& working_;
  const Mesh& mesh_;
  const GeneratorTable& table_;
  Front front_;
  const Progress& progress_;
  NearestLabels labels_;
  Crossings rough_;
  std::vector<Gap> gaps_;
  std::vector<char> may_grow_;  // per gap: growth has not failed there
  std::vector<EdgeId> plain_;   // edges whose inside runs were taken away, ascending
  std::int64_t relabelled_ = 0;
  int rounds_ = 0;
};

}  // namespace

TracedDiagram trace_diagram(const WorkingMesh& working, const GeneratorTable& table, const DiagramOptions& options,
                            DiagramReport& report) {
  report_progress(options.progress, "bisectors", 0);
  return Tracer(working, table, options).run(report);
}

}  // namespace gvd
