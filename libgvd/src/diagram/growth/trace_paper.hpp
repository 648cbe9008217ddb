#pragma once

#include <array>
#include <optional>
#include <vector>

#include "diagram/graph/connected_tracer.hpp"
#include "diagram/growth/gap_tracer.hpp"
#include "diagram/growth/refine_bisectors.hpp"

namespace gvd {

/// The rules of section 4.3, and the second principle of section 3.
inline constexpr GrowthRules kPaperRules{GrowthRules::Images::rotated, GrowthRules::Direction::of_segment,
                                         EventOrder::by_distance, true};

/// The auxiliary points of section 4.1: distances of generator g at the three edge midpoints of a face, mesh units;
/// item i belongs to the edge from corner i to the next corner. The field of a generator is linear in a face, so that
/// each distance is the mean of the distances at two corners. Nothing if g does not reach f. Cost: O(entries of the
/// face's table).
std::optional<std::array<double, 3>> find_midpoint_distances(const GeneratorTable& table, FaceId f, GeneratorId g);

/// The rough bisectors of section 4.2: in an ordinary face, the segment between the midpoints of the two edges whose
/// ends have different nearest generators. Every such edge is therefore crossed at its midpoint. Cost: O(n).
Crossings find_rough_segments(const Mesh& mesh, const NearestLabels& labels);

/// Refines the rough segment of every ordinary face (section 4.2, figure 6): both generators are unfolded into the
/// face's plane from their distances at the segment's ends, each to the side of the corners whose nearest generator it
/// is. The segment moves to the bisector of the two images.
///
/// Returns an estimate for each end, ascending by face; there is none if the bisector leaves the edge, or if the tables
/// lack one of the two generators. Cost: O(k) for k crossings.
std::vector<CrossingEstimate> refine_segments(const Mesh& mesh, const GeneratorTable& table,
                                              const Crossings& crossings);

/// The steps of sections 4.2 and 4.3 exactly as in the paper: rough segments between edge midpoints, which are refined
/// by unfolding from the midpoints' distances, and growth through the branching faces.
///
/// A set of branching faces that growth does not close is assembled from its edge crossings, because the paper does not
/// say how to continue. `trace_connected` runs the steps. Counts gaps; reports the steps "bisectors" and "growth".
/// Cost: O(n).
class PaperTracer : public GapTracer {
 public:
  /// All references must outlive the tracer.
  PaperTracer(const WorkingMesh& working, const GeneratorTable& table, Front front, const Progress& progress);

  Crossings cross_edges(const NearestLabels& labels) const override;
  /// Replaces the crossings of these edges by one crossing at the midpoint, or none if their ends have the same label.
  void cross_at_most_once(const std::vector<EdgeId>& edges, const NearestLabels& labels,
                          Crossings& crossings) const override;
  void close_faces(TracedDiagram& traced) override;
};

}  // namespace gvd
