#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "diagram/graph/crossings.hpp"
#include "diagram/growth/gaps.hpp"
#include "diagram/growth/growth_input.hpp"

namespace gvd {

/// A place where growth starts, passes or ends.
struct GapNode {
  enum class Kind { rim, crossing, branch };
  Kind kind;
  CrossingId rim;                ///< rim: the crossing that was there before
  Crossing crossing{};           ///< crossing: a new one, inside the gap or on the mesh's boundary
  FaceId face;                   ///< branch
  std::array<double, 3> bary{};  ///< branch
  double distance = 0;           ///< branch: predicted distance to its generators, mesh units
};

struct GapArc {
  FaceId face;
  int begin, end;  ///< nodes
  GeneratorId left, right;
};

/// How the bisectors run inside one gap.
struct GrownGap {
  std::vector<GapNode> nodes;
  std::vector<GapArc> arcs;
  std::vector<std::pair<VertexId, GeneratorId>>
      labels;  ///< of the gap's vertices, where growth moved them to another cell
};

/// Grows the bisectors that reach the gap's rim through its inside until every end is resolved.
///
/// Two kinds of event, by predicted distance: ends that meet inside a face become one, from a branch point on; an end
/// that leaves its face crosses the edge, and its generators' images are rotated around that edge into the next face's
/// plane. Meetings inside a face come before exits from it, for distance is not monotone along a bisector.
/// Source: section 4.3.
/// Returns nothing where the ends do not meet up, or do so in a way that contradicts itself: ends left over, arcs that
/// cross, an edge or a vertex between two labels. Then the gap is closed by assembly, which can't fail.
/// Cost: O(k^3) for k ends, grown ones included: every event looks at all pairs. k is bounded by the faces of the gap.
std::optional<GrownGap> grow_gap(const GrowthInput& input, const Crossings& crossings, const Gap& gap);

}  // namespace gvd
