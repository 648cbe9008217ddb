#pragma once

#include <optional>

#include "diagram/growth/growing_end.hpp"
#include "diagram/growth/grown_gap.hpp"
#include "diagram/growth/growth_input.hpp"

namespace gvd {

/// The largest number of faces of a gap that bisectors grow through. Larger gaps contain whole cells, and the images of
/// the generators become too inaccurate on the way through.
inline constexpr std::size_t kMaxGapFaces = 200;

/// The rules by which bisectors grow through a gap.
struct GrowthRules {
  /// The origin of the images of an end's generators when the end enters a face.
  enum class Images {
    rotated,   ///< from the previous face, rotated around the edge
    unfolded,  ///< from the distances at the face's corners; rotated if the tables have none
  };
  /// The origin of an end's direction when it starts at the rim and when it enters a face. After an intersection the
  /// images always give the direction.
  enum class Direction {
    of_images,   ///< along the bisector of the two images
    of_segment,  ///< along the traced segment in the face before the rim, carried over each edge by (7) to (10)
  };
  Images images = Images::rotated;
  Direction direction = Direction::of_images;
  EventOrder order = EventOrder::by_kind;
  /// Whether an intersection must be equally far from its three generators, and farther from all other generators
  /// (section 3).
  bool require_equidistance = false;
};

/// The result of growing through a gap.
struct GrowthOutcome {
  std::optional<GrownGap> grown;  ///< none if growth failed
  FaceId entered;                 ///< the face outside the gap that an end wants to enter; invalid if there is none
};

/// Grows the bisectors that cross the gap's rim through its faces, until every end is resolved.
///
/// There are two kinds of event. Ends that intersect inside a face are merged to one end at a branch point. An end that
/// leaves its face crosses the edge, and continues in the next face with the images of its generators there. The event
/// with the least predicted distance comes first; an end's predicted distance is the mean of the distances to its two
/// images.
///
/// Source: section 4.3. Deviations: two ends of one bisector that face each other are joined before any event; the
/// result is checked as a whole (`check_growth`), and no end is ever drawn back. With the default rules, intersections
/// come before exits, because distance is not monotone along a bisector, and ends follow the bisector of their images.
/// Growth fails if an end stays unresolved or wants to leave the gap, if the check fails, if the gap has more than
/// kMaxGapFaces faces, or if a segment has to be stretched and the face outside has none because it has three labels.
/// Cost: O(k^2) for k ends, including ends in later faces; k is bounded by the number of faces of the gap.
GrowthOutcome grow_bisectors(const GrowthInput& input, const Crossings& crossings, const Gap& gap,
                             const GrowthRules& rules = {});

}  // namespace gvd
