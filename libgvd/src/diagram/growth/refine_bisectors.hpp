#pragma once

#include <array>
#include <vector>

#include "diagram/graph/crossings.hpp"
#include "diagram/growth/growth_input.hpp"
#include "gvd/progress.hpp"

namespace gvd {

/// The position of a crossing as estimated by one of its faces.
struct CrossingEstimate {
  CrossingId crossing;
  double t;  ///< parameter along the edge's halfedge
};

/// Estimates the crossings of every face with exactly one bisector: both generators are unfolded into the face's plane,
/// and the bisector becomes the perpendicular bisector of their images.
///
/// Source: section 4.2 (refinement by unfolding). Deviation: the paper unfolds from the distances at the midpoints of
/// the two crossed edges; here, a generator is unfolded from the distances at the ends of the edge through which its
/// front enters.
/// Returns at most two estimates per crossing, one from each face, ascending by face. Estimates outside the edge are
/// left out. Reports the third quarter of the step "bisectors". Cost: O(k) for k crossings.
std::vector<CrossingEstimate> refine_bisectors(const GrowthInput& input, const Crossings& crossings,
                                               const Progress& progress = {});

/// Images of two generators in the plane of a face with these corners.
struct FaceImages {
  FaceId face;
  std::array<Vec2, 3> corner;
  Vec2 first, second;
};

/// Appends an estimate for each of a face's two crossings: the point where the perpendicular bisector of the images
/// meets the edge. There is no estimate if that point lies outside the edge. The paper's tracer shares this step.
void estimate_crossings(const Mesh& mesh, const Crossings& crossings, const std::vector<BoundaryCrossing>& ends,
                        const FaceImages& images, std::vector<CrossingEstimate>& estimates);

/// Moves every crossing to the mean of the estimates of its two faces.
///
/// Source: section 4.2 (consistency enforcement). A crossing without an estimate stays. Deviation: crossings keep their
/// order on the edge, and kCrossingGap from each other and from its ends. Cost: O(k) for k crossings and estimates.
void weld_crossings(const std::vector<CrossingEstimate>& estimates, Crossings& crossings);

}  // namespace gvd
