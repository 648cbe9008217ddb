#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "diagram/graph/crossings.hpp"
#include "diagram/growth/gaps.hpp"
#include "diagram/growth/growth_input.hpp"

namespace gvd {

/// A node of the graph that grows in a gap: a crossing on the rim, a new crossing, or a branch point.
struct GapNode {
  enum class Kind { rim, crossing, branch };
  Kind kind;
  CrossingId rim;                ///< rim: the crossing that was there before
  Crossing crossing{};           ///< crossing: inside the gap or on the mesh's boundary
  FaceId face;                   ///< branch
  std::array<double, 3> bary{};  ///< branch: in `face`
  double distance = 0;           ///< branch: predicted distance to its generators, mesh units
};

/// A straight part of a bisector inside one face of the gap.
struct GapArc {
  FaceId face;
  int begin, end;           ///< indices of nodes
  GeneratorId left, right;  ///< on the way from begin to end
};

/// The bisectors inside one gap.
struct GrownGap {
  std::vector<GapNode> nodes;
  std::vector<GapArc> arcs;
  std::vector<std::pair<VertexId, GeneratorId>> labels;  ///< of vertices that growth gave to another cell, ascending
};

/// Grows the bisectors that cross the gap's rim through its faces, until every end is resolved.
///
/// There are two kinds of event. Ends that intersect inside a face are merged to one at a branch point. An end that
/// leaves its face crosses the edge, and the images of its generators are rotated around that edge into the plane of
/// the next face. The event of least predicted distance comes first, where an end's predicted distance is the mean of
/// those to its two images.
///
/// Source: section 4.3. Deviations: two ends of one bisector that face each other are joined before any event;
/// intersections come before exits, since distance is not monotone along a bisector; generators are unfolded once, in
/// the face outside the gap; the result is checked as a whole (`check_growth`), and no end is ever drawn back.
/// Returns nothing if an end stays unresolved, the check fails, or the gap has more than 200 faces; `assemble_faces`
/// closes such a gap. Cost: O(k^3) for k ends, those of later faces included; k is bounded by the faces of the gap.
std::optional<GrownGap> grow_gap(const GrowthInput& input, const Crossings& crossings, const Gap& gap);

}  // namespace gvd
