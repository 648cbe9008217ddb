#pragma once

#include <vector>

#include "diagram/assembly/face_distances.hpp"
#include "diagram/graph/crossings.hpp"
#include "diagram/graph/face_diagram.hpp"

namespace gvd {

/// Joins the crossings on the boundary of face f by arcs that don't cross, and appends arcs and branch points to
/// `diagram`.
///
/// Two crossings make an arc, three a branch point. With more, two label intervals of one generator are united where
/// that generator is the nearest one between them. Otherwise three consecutive intervals are contracted to a branch
/// point. Both leave smaller problems of the same kind. The crossings are the corners of a convex polygon, and every
/// step keeps the remaining polygons convex. So the arcs can't cross, whatever the distances are.
///
/// Branch points that the distances confirm come first and are not moved.
/// Inputs: `boundary` has 0 or at least 2 crossings, counter-clockwise; `distances` knows the generators on it.
/// Source: sections 4.2 and 4.3 of the paper, which leave open how a face with many crossings is closed.
/// Cost: O(k^5) for k crossings at worst (k rounds, each over all pairs of intervals and all cells); k is seldom above
/// 4.
void assemble_face(FaceId f, const std::vector<BoundaryCrossing>& boundary, const FaceDistances& distances,
                   FaceDiagram& diagram);

}  // namespace gvd
