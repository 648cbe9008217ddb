#pragma once

#include <utility>
#include <vector>

#include "diagram/graph/connected_tracer.hpp"
#include "diagram/growth/close_gaps.hpp"
#include "diagram/growth/rough_bisectors.hpp"
#include "gvd/progress.hpp"

namespace gvd {

/// The common part of tracers whose bisectors grow through gaps.
class GapTracer : public DiagramTracer {
 public:
  /// From now on, the tracer assembles all faces with one of these edges, which ascend, and the gaps to which these
  /// faces belong.
  void disable_growth(const std::vector<EdgeId>& edges) override { plan_.forbid(edges); }

 protected:
  /// All references must outlive the tracer. `rules` are tried in this order.
  GapTracer(const WorkingMesh& working, const GeneratorTable& table, Front front, const Progress& progress,
            std::vector<GrowthRules> rules)
      : working_(working),
        table_(table),
        front_(front),
        progress_(progress),
        plan_{std::move(rules), kEnlargements, {}} {}

  GrowthInput input(const NearestLabels& labels) const { return {working_, table_, labels, front_}; }
  const Mesh& mesh() const { return working_.mesh(); }
  const GeneratorTable& table() const { return table_; }
  Front front() const { return front_; }
  const Progress& progress() const { return progress_; }
  /// Fills in the arcs and branch points of all crossed faces, ascending by face: by growth through the gaps, and by
  /// assembly in all other faces. Growth may replace crossings and labels inside the gaps. Counts the gaps.
  /// Cost: O(n).
  void close(const std::vector<Gap>& gaps, TracedDiagram& traced) const;

 private:
  /// How many times a gap is enlarged if it does not close. With this value, nearly all gaps close
  /// (docs/notes/performance.md). The paper names no limit.
  static constexpr int kEnlargements = 10;

  const WorkingMesh& working_;
  const GeneratorTable& table_;
  Front front_;
  const Progress& progress_;
  ClosingPlan plan_;
};

/// The paper's tracer, improved: rough bisectors, refined and welded (section 4.2), and growth through the gaps
/// (section 4.3).
///
/// Whether the diagram is complete does not depend on the growth, because a gap that growth does not close is assembled
/// from its edge crossings. The paper has no such fallback. `trace_connected` runs the steps.
/// Counts gaps; reports the steps "bisectors" and "growth". Cost: O(n).
class GrowthTracer : public GapTracer {
 public:
  /// All references must outlive the tracer.
  GrowthTracer(const WorkingMesh& working, const GeneratorTable& table, Front front, const Progress& progress);

  Crossings cross_edges(const NearestLabels& labels) const override;
  void cross_at_most_once(const std::vector<EdgeId>& edges, const NearestLabels& labels,
                          Crossings& crossings) const override;
  /// Refines the crossings, then fills in the arcs and branch points of all faces, ascending by face: by growth inside
  /// the gaps, by assembly elsewhere. Growth may replace crossings and labels inside its gaps.
  void close_faces(TracedDiagram& traced) override;

 private:
  std::vector<Gap> gaps_;
};

}  // namespace gvd
