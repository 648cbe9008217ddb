#pragma once

#include <vector>

#include "diagram/graph/traced_diagram.hpp"
#include "diagram/growth/grow_bisectors.hpp"
#include "diagram/growth/grown_gap.hpp"
#include "diagram/growth/growth_input.hpp"
#include "gvd/progress.hpp"

namespace gvd {

/// Finds the connected sets of faces whose entry is not 0, ascending by their first face. Cost: O(n).
std::vector<Gap> connect_gaps(const Mesh& mesh, const IdVector<FaceId, char>& is_in_gap);

/// Finds the gaps: connected sets of faces whose tables hold three or more generators that are not dominated.
std::vector<Gap> find_gaps(const Mesh& mesh, const GeneratorTable& table);

/// The rules and limits of closing gaps.
struct ClosingPlan {
  std::vector<GrowthRules> rules;  ///< tried in this order
  /// How many times a gap is enlarged after all rules have failed.
  int enlargements = 0;
  /// Edges where growth is not allowed, ascending. A gap with one of these edges does not grow.
  std::vector<EdgeId> forbidden;

  /// Forbids more edges, ascending. Cost: O(edges).
  void forbid(const std::vector<EdgeId>& edges);
};

/// Grows bisectors through all gaps, and enlarges the gaps that do not close.
///
/// Nearly every gap that does not close has an end that wants to leave it. Then the gap takes the face that the end
/// wants to enter, and the whole gap to which that face belongs. Every fourth time, and if no end wants to leave, it
/// takes all faces around it. Growth starts over each time. A gap that closes in the end replaces the gaps that it
/// took.
///
/// Source: section 4.3, which stretches ends without a limit. Returns the closed gaps, which have no face in common.
/// Reports the step "growth". Cost: O(n) for n faces, and at most `enlargements` + 1 growths a gap and rule.
std::vector<ClosedGap> close_gaps(const GrowthInput& input, const Crossings& crossings, const std::vector<Gap>& gaps,
                                  const ClosingPlan& plan, const Progress& progress);

/// Replaces the crossings inside the closed gaps by the crossings that grew, appends the arcs and branch points of the
/// gaps to `traced.faces`, and gives the vertices that growth moved to another cell their new labels. Cost: O(n + k log
/// k) for k crossings.
void install_gaps(const Mesh& mesh, const std::vector<ClosedGap>& closed, TracedDiagram& traced);

}  // namespace gvd
