#pragma once

#include <vector>

#include "diagram/assembly/face_distances.hpp"
#include "diagram/graph/crossings.hpp"
#include "diagram/graph/face_diagram.hpp"

namespace gvd {

/// Joins the crossings on the boundary of face f by arcs that don't cross, and appends them to `diagram`.
///
/// Two crossings make an arc, three a branch point. Of more, two runs of one generator are united where that generator
/// is the nearest one between them, or else three consecutive runs are contracted to a branch point; both leave a
/// smaller problem of the same kind. The crossings, taken round the face, are the corners of a convex polygon, and
/// every step keeps what remains convex: so the arcs can't cross, whatever the distances say.
///
/// Where the metric knows a branch point for sure, it is taken first, and as it is.
/// `boundary` has 0 or at least 2 crossings; `metric` knows the generators on it.
/// Source: sections 4.2 and 4.3; closed by construction, see docs/developer/algorithm.md.
/// Cost: O(k^5) for k crossings at worst (k rounds, each over all pairs of runs and all cells there); k is seldom
/// above 4.
void assemble_face(FaceId f, const std::vector<BoundaryCrossing>& boundary, const FaceDistances& distances,
                   FaceDiagram& diagram);

}  // namespace gvd
