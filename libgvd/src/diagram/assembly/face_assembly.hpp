#pragma once

#include <cstddef>
#include <vector>

#include "diagram/assembly/face_distances.hpp"
#include "diagram/assembly/face_polygon.hpp"
#include "diagram/graph/crossings.hpp"
#include "diagram/graph/face_diagram.hpp"

namespace gvd {

/// Joins the crossings on the boundary of face f by arcs that don't cross, and appends arcs and branch points to
/// `diagram`. Branch points that the paths confirm come first and are not moved.
/// Inputs: `boundary` has 0 or at least 2 crossings, counter-clockwise; `distances` knows the generators on it. `paths`
/// are the paths of the same distances. If null, all branch points are guesses, and every step keeps polygons convex.
/// Cost: O(k^5) for k crossings at worst (k rounds, each over all pairs of intervals and all cells); k is seldom above
/// 4.
void assemble_face(FaceId f, const std::vector<BoundaryCrossing>& boundary, const FaceDistances& distances,
                   FaceDiagram& diagram, const FacePaths* paths = nullptr);

/// Two label intervals of the same generator, given by the corners i < j of a polygon at which they begin.
struct IntervalPair {
  /// How much farther their generator is than the nearest other generator, halfway between the two intervals; negative
  /// if it is nearer.
  double excess;
  std::size_t i, j;

  /// Whether arcs that unite this pair must cross arcs that unite the other pair.
  bool crosses(const IntervalPair& other) const;
};

/// Finds the pairs of intervals to unite to one piece each, none of which crosses another pair. These are the pairs
/// whose generator is the nearest one halfway between them, ascending by excess. If there are none, it is the pair of
/// least excess if one pair must be united: because no three consecutive intervals have different generators, or
/// because the distances are accurate and their paths have confirmed no branch point.
/// Cost: O(k^3) for k corners.
std::vector<IntervalPair> find_pairs_to_unite(const FacePolygon& polygon, const FaceDistances& distances,
                                              bool is_accurate);

}  // namespace gvd
