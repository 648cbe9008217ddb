#pragma once

#include <utility>
#include <vector>

#include "diagram/graph/connected_tracer.hpp"
#include "diagram/growth/grow_gaps.hpp"
#include "diagram/growth/growth_input.hpp"
#include "gvd/progress.hpp"

namespace gvd {

/// What tracers share whose bisectors grow through gaps.
class GrowingTracer : public DiagramTracer {
 public:
  /// From now on, assembles all faces with one of these edges, ascending, and the gaps that they belong to.
  void disable_growth(const std::vector<EdgeId>& edges) override { plan_.forbid(edges); }

 protected:
  /// All references must outlive the tracer. `rules`: tried in this order.
  GrowingTracer(const WorkingMesh& working, const GeneratorTable& table, Front front, const Progress& progress,
                std::vector<GrowthRules> rules)
      : working_(working),
        table_(table),
        front_(front),
        progress_(progress),
        plan_{std::move(rules), kEnlargements, {}} {}

  GrowthInput input(const NearestLabels& labels) const { return {working_, table_, labels, front_}; }
  const Mesh& mesh() const { return working_.mesh(); }
  Front front() const { return front_; }
  const Progress& progress() const { return progress_; }
  /// Fills in the arcs and branch points of all crossed faces, ascending by face: by growth through the gaps, and by
  /// assembly in all other faces. Growth may replace crossings and labels inside of the gaps. Counts the gaps. Cost:
  /// O(n).
  void close(const std::vector<Gap>& gaps, TracedDiagram& traced) const;

 private:
  /// How often a gap that does not close is enlarged. Measured on four meshes with 780 gaps: of 95 that do not close at
  /// first, 9 stay open with 6, 5 with 10 and 2 with 20, at up to four times the time. The paper names no limit.
  static constexpr int kEnlargements = 10;

  const WorkingMesh& working_;
  const GeneratorTable& table_;
  Front front_;
  const Progress& progress_;
  GapGrowthPlan plan_;
};

}  // namespace gvd
