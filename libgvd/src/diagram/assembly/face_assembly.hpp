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
/// Inputs: `boundary` has 0 or at least 2 crossings, counter-clockwise; `distances` knows the generators on it. `paths`:
/// those of the same distances, or null, so that all branch points are guesses and every step keeps polygons convex.
/// Cost: O(k^5) for k crossings at worst (k rounds, each over all pairs of intervals and all cells); k is seldom above
/// 4.
void assemble_face(FaceId f, const std::vector<BoundaryCrossing>& boundary, const FaceDistances& distances,
                   FaceDiagram& diagram, const FacePaths* paths = nullptr);

/// Two label intervals of one generator, by the corners i < j of a polygon that they begin at.
struct IntervalPair {
  /// How much farther their generator is than the nearest other one, halfway between the two; < 0: nearer.
  double excess;
  std::size_t i, j;

  /// Whether arcs that unite the one pair must cross those that unite the other.
  bool crosses(const IntervalPair& other) const;
};

/// The pairs of intervals to unite to one piece each, none of which crosses another one: those whose generator is the
/// nearest one halfway between them, ascending by excess. Where there are none, the pair of least excess, if one must
/// be united: no three consecutive intervals have different generators, or the distances are accurate and their paths
/// have confirmed no branch point.
/// Cost: O(k^3) for k corners.
std::vector<IntervalPair> find_pairs_to_unite(const FacePolygon& polygon, const FaceDistances& distances,
                                              bool is_accurate);

}  // namespace gvd
