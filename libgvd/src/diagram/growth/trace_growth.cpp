#include "diagram/growth/trace_growth.hpp"

#include <algorithm>

#include "diagram/graph/connected_tracer.hpp"
#include "diagram/growth/assemble_faces.hpp"
#include "diagram/growth/growth.hpp"
#include "diagram/growth/install_gaps.hpp"
#include "diagram/growth/refine_bisectors.hpp"
#include "diagram/growth/rough_bisectors.hpp"
#include "diagram/growth/weld_crossings.hpp"

namespace gvd {
namespace {

/// Progress is reported once in so many gaps.
constexpr std::size_t kProgressStride = 1 << 5;

class GrowthTracer final : public ConnectedTracer {
 public:
  GrowthTracer(const WorkingMesh& working, const GeneratorTable& table, const DiagramOptions& options)
      : ConnectedTracer(working, compute_nearest_labels(working, table), options.progress),
        table_(table),
        front_(options.front),
        gaps_(find_gaps(mesh_, table)),
        may_grow_(gaps_.size(), 1) {}

 private:
  Crossings cross_edges() override { return find_rough_crossings(working_, table_, labels_, front_, progress_); }

  void cross_at_most_once(const std::vector<EdgeId>& edges, Crossings& crossings) override {
    gvd::cross_at_most_once(working_, table_, labels_, front_, edges, crossings);
  }

  void close_faces(TracedDiagram& traced, DiagramReport& report) override {
    refine(traced.crossings);
    report.gaps = static_cast<std::int64_t>(gaps_.size());
    report.gaps_grown = grow(traced);
    report.gaps_assembled = report.gaps - report.gaps_grown;
    assemble_rest(traced);
  }

  void disable_growth(const std::vector<EdgeId>& edges) override {
    for (std::size_t i = 0; i < gaps_.size(); ++i) {
      if (may_grow_[i] && touches(gaps_[i], edges)) may_grow_[i] = 0;
    }
  }

  void disable_growth_everywhere() override { std::fill(may_grow_.begin(), may_grow_.end(), 0); }

  /// With planar fronts the rough crossings interpolate distances, and unfolding makes them better. With circles they
  /// come from sources that were unfolded over the very edge, the same for both of its faces: there is nothing to
  /// refine or weld, and images unfolded over other edges would make them worse (docs/notes/performance.md has the
  /// figures).
  void refine(Crossings& crossings) const {
    if (front_ == Front::circle) return;
    weld_crossings(refine_bisectors(working_, table_, labels_, crossings, progress_), crossings);
  }

  /// Grows every gap that may; returns how many closed.
  std::int64_t grow(TracedDiagram& traced) {
    std::vector<ClosedGap> closed;
    report_progress(progress_, "growth", 0);
    for (std::size_t i = 0; i < gaps_.size(); ++i) {
      if (!may_grow_[i]) continue;
      if (i % kProgressStride == 0) report_progress(progress_, "growth", double(i) / double(gaps_.size()));
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
    assemble_faces({mesh_, table_, traced.labels, front_}, traced.crossings, grown, traced.faces, progress_);
    std::stable_sort(traced.faces.arcs.begin(), traced.faces.arcs.end(),
                     [](const FaceArc& a, const FaceArc& b) { return a.face < b.face; });
  }

  bool touches(const Gap& gap, const std::vector<EdgeId>& edges) const {
    return std::any_of(edges.begin(), edges.end(), [&](EdgeId e) {
      const HalfedgeId h = mesh_.halfedge(e), twin = mesh_.twin(h);
      return gap.contains(Mesh::face(h)) || (twin.valid() && gap.contains(Mesh::face(twin)));
    });
  }

  const GeneratorTable& table_;
  Front front_;
  std::vector<Gap> gaps_;
  std::vector<char> may_grow_;  // per gap: growth has not failed there
};

}  // namespace

TracedDiagram trace_growth(const WorkingMesh& working, const GeneratorTable& table, const DiagramOptions& options,
                           DiagramReport& report) {
  return GrowthTracer(working, table, options).run(report);
}

}  // namespace gvd
