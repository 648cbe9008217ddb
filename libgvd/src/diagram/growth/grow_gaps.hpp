#pragma once

#include <vector>

#include "diagram/growth/gaps.hpp"
#include "diagram/growth/growth.hpp"
#include "gvd/progress.hpp"

namespace gvd {

/// A gap and the bisectors that grew in it. It may be several gaps that met, with faces between and around them.
struct ClosedGap {
  Gap gap;
  GrownGap grown;
  std::vector<std::size_t> merged;  ///< indices of the gaps that it closes, ascending
};

/// What growth may do.
struct GapGrowthPlan {
  std::vector<GrowthRules> rules;  ///< tried in this order
  /// How often a gap is enlarged after all rules failed.
  int enlargements = 0;
  /// Edges where growth is not allowed, ascending: a gap does not grow with one of them.
  std::vector<EdgeId> forbidden;

  /// Forbids more edges, ascending. Cost: O(edges).
  void forbid(const std::vector<EdgeId>& edges);
};

/// Grows through all gaps, and enlarges those that do not close.
///
/// Nearly every gap that does not close has an end that wants to leave it. Then the gap takes the face that the end
/// wants to enter, and the whole gap that the face belongs to. Every fourth time, and where no end leaves, it takes all
/// faces around it. Growth starts anew each time. A gap that closes at last replaces those that it took.
///
/// Source: section 4.3, which stretches ends without a limit. Returns the closed gaps, which have no face in common.
/// Reports the step "growth". Cost: O(n) for n faces, and at most `enlargements` + 1 growths a gap and rule.
std::vector<ClosedGap> grow_gaps(const GrowthInput& input, const Crossings& crossings, const std::vector<Gap>& gaps,
                                 const GapGrowthPlan& plan, const Progress& progress);

}  // namespace gvd
