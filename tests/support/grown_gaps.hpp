#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "diagram/growth/check_growth.hpp"
#include "diagram/growth/close_gaps.hpp"
#include "support/stages.hpp"

namespace gvd::test {

/// The gaps of a mesh, each with the result of its growth.
struct GrownGaps {
  Stages stages;
  std::vector<Gap> gaps;
  std::vector<std::optional<GrownGap>> grown;
  int closed = 0;

  GrownGaps(const Mesh& mesh, const std::vector<SurfacePoint>& generators, Front front = Front::circle)
      : stages(mesh, generators, front), gaps(find_gaps(stages.mesh(), stages.table())) {
    for (const Gap& gap : gaps) {
      grown.push_back(grow_bisectors(stages.input(), stages.rough, gap).grown);
      closed += grown.back().has_value() ? 1 : 0;
    }
  }

  bool check(std::size_t i, GrownGap candidate) const {
    return check_growth(stages.working, stages.labels, stages.rough, gaps[i], candidate);
  }
};

inline std::ptrdiff_t count_nodes(const GrownGap& grown, GapNode::Kind kind) {
  return std::count_if(grown.nodes.begin(), grown.nodes.end(), [&](const GapNode& n) { return n.kind == kind; });
}

}  // namespace gvd::test
