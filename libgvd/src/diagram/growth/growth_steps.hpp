#pragma once

#include <vector>

#include "diagram/assembly/form_distances.hpp"
#include "diagram/graph/traced_diagram.hpp"
#include "diagram/growth/grow_bisectors.hpp"
#include "diagram/growth/grown_gap.hpp"
#include "diagram/growth/growth_input.hpp"
#include "gvd/progress.hpp"

// The steps of growth in their order. The tracers of gap_tracer.hpp and trace_paper.hpp run them.
namespace gvd {

/// The crossings of the rough bisectors with the edges: on each half of an edge, the lower envelope of linear distances
/// from an end to the midpoint, of the generators in the tables of the edge's two faces.
///
/// Source: section 4.2 (rough bisectors), with the auxiliary midpoints of section 4.1. Deviation: the paper joins edge
/// midpoints in faces of two labels. Here a crossing lies where two distances are equal along the edge, and an edge may
/// have several: a cell can own the inside of an edge whose two ends belong to others.
/// Reports the first half of the step "bisectors". Cost: O(k) for the k edges near bisectors.
Crossings find_rough_crossings(const GrowthInput& input, const Progress& progress = {});

/// Replaces the crossings of the given edges, ascending, by at most one each, between the labels of the edge's ends.
/// Cost: O(k) for k crossings and edges.
void cross_at_most_once(const GrowthInput& input, const std::vector<EdgeId>& edges, Crossings& crossings);

/// The position of a crossing as estimated by one of its faces.
struct CrossingEstimate {
  CrossingId crossing;
  double t;  ///< parameter along the edge's halfedge
};

/// Estimates the crossings of every face with exactly one bisector: both generators are unfolded into the face's plane,
/// and the bisector becomes the perpendicular bisector of their images.
///
/// Source: section 4.2 (refinement by unfolding). Deviation: the paper unfolds from the distances at the midpoints of
/// the two crossed edges; here a generator is unfolded from those at the ends of the edge that its front enters by.
/// Returns at most two estimates a crossing, one from each face, ascending by face; none that lies outside its edge.
/// Reports the third quarter of the step "bisectors". Cost: O(k) for k crossings.
std::vector<CrossingEstimate> refine_bisectors(const GrowthInput& input, const Crossings& crossings,
                                               const Progress& progress = {});

/// Images of two generators in the plane of a face with these corners.
struct FaceImages {
  FaceId face;
  std::array<Vec2, 3> corner;
  Vec2 first, second;
};

/// Appends an estimate for each of a face's two crossings: where the perpendicular bisector of the images meets its
/// edge. There is none where that lies outside the edge. The paper's tracer shares this step.
void estimate_crossings(const Mesh& mesh, const Crossings& crossings, const std::vector<BoundaryCrossing>& ends,
                        const FaceImages& images, std::vector<CrossingEstimate>& estimates);

/// Moves every crossing to the mean of the estimates of its two faces.
///
/// Source: section 4.2 (consistency enforcement). A crossing without an estimate stays. Deviation: crossings keep their
/// order on the edge, and kCrossingGap from each other and from its ends. Cost: O(k) for k crossings and estimates.
void weld_crossings(const std::vector<CrossingEstimate>& estimates, Crossings& crossings);

/// The connected sets of the faces whose entry is not 0, ascending by their first face. Cost: O(n).
std::vector<Gap> connect_gaps(const Mesh& mesh, const IdVector<FaceId, char>& is_in_gap);

/// The gaps of the faces whose tables hold three or more generators that are not dominated.
std::vector<Gap> find_gaps(const Mesh& mesh, const GeneratorTable& table);

/// The rules and limits of closing gaps.
struct ClosingPlan {
  std::vector<GrowthRules> rules;  ///< tried in this order
  /// The number of times that a gap is enlarged after all rules failed.
  int enlargements = 0;
  /// Edges where growth is not allowed, ascending: a gap does not grow with one of them.
  std::vector<EdgeId> forbidden;

  /// Forbids more edges, ascending. Cost: O(edges).
  void forbid(const std::vector<EdgeId>& edges);
};

/// Grows bisectors through all gaps, and enlarges the gaps that do not close.
///
/// Nearly every gap that does not close has an end that wants to leave it. Then the gap takes the face that the end
/// wants to enter, and the whole gap that the face belongs to. Every fourth time, and where no end leaves, it takes all
/// faces around it. Growth starts anew each time. A gap that closes at last replaces those that it took.
///
/// Source: section 4.3, which stretches ends without a limit. Returns the closed gaps, which have no face in common.
/// Reports the step "growth". Cost: O(n) for n faces, and at most `enlargements` + 1 growths a gap and rule.
std::vector<ClosedGap> close_gaps(const GrowthInput& input, const Crossings& crossings, const std::vector<Gap>& gaps,
                                  const ClosingPlan& plan, const Progress& progress);

/// Replaces the crossings inside the closed gaps by those that grew, appends their arcs and branch points to
/// `traced.faces`, and gives the vertices that growth moved their new labels. Cost: O(n + k log k) for k crossings.
void install_gaps(const Mesh& mesh, const std::vector<ClosedGap>& closed, TracedDiagram& traced);

/// The distance forms of the generators whose cells lie along a face's boundary, ascending by generator.
std::vector<DistanceForm> face_forms(const GrowthInput& input, FaceId f, const std::vector<BoundaryCrossing>& boundary);

/// Joins the crossings in every crossed face but those in `skipped`, ascending; appends the arcs and branch points to
/// `diagram`. Reports the last quarter of the step "bisectors".
///
/// Source: none; the paper draws one segment in a face of two labels (section 4.2) and leaves the others to growth.
/// Cost: O(k) for k faces near bisectors.
void assemble_faces(const GrowthInput& input, const Crossings& crossings, const std::vector<FaceId>& skipped,
                    FaceDiagram& diagram, const Progress& progress = {});

}  // namespace gvd
