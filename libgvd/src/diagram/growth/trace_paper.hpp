#pragma once

#include <array>
#include <optional>
#include <vector>

#include "diagram/graph/connected_tracer.hpp"
#include "diagram/growth/gap_tracer.hpp"

namespace gvd {

/// The auxiliary points of section 4.1: for each face and each generator in its table, distances at the three edge
/// midpoints, mesh units. The field of a generator is linear in a face, so that each is the mean of two corners'.
class MidpointDistances {
 public:
  /// Memory: 24 bytes an entry of the tables. Cost: O(entries).
  MidpointDistances(const GeneratorTable& table, std::int32_t face_count);

  /// The distances of generator g in face f; item i belongs to the edge from corner i to the next. Nothing where g does
  /// not reach f. Cost: O(entries of the face).
  std::optional<std::array<double, 3>> find(FaceId f, GeneratorId g) const;

 private:
  const GeneratorTable& table_;
  std::vector<std::array<double, 3>> of_entry_;
};

/// The rough bisectors of section 4.2: in an ordinary face the segment between the midpoints of the two edges whose
/// ends have different nearest generators. So every such edge is crossed at its midpoint. Cost: O(n).
Crossings find_rough_segments(const Mesh& mesh, const NearestLabels& labels);

/// Puts these edges, ascending, back to one crossing at the midpoint, or none if their ends have one label.
void cross_at_midpoints(const Mesh& mesh, const std::vector<EdgeId>& edges, const NearestLabels& labels,
                        Crossings& crossings);

/// Refines the rough segment of every ordinary face (section 4.2, figure 6): both generators are unfolded into the
/// face's plane from their distances at the segment's ends, each to the side of the corners that it is nearest to. The
/// segment moves to the bisector of the two images.
///
/// Returns an estimate for each end, ascending by face; none where the bisector leaves the edge, or where the tables
/// miss one of the two generators. Cost: O(k) for k crossings.
std::vector<CrossingEstimate> refine_segments(const Mesh& mesh, const MidpointDistances& midpoints,
                                              const Crossings& crossings);

/// The steps of sections 4.2 and 4.3 as the paper has them: rough segments between edge midpoints, refined by unfolding
/// from the midpoints' distances, and growth through the branching faces.
///
/// A set of branching faces that growth does not close is assembled from its edge crossings, because the paper does not
/// say how to go on. `trace_connected` runs the steps. Counts gaps; reports the steps "bisectors" and "growth".
/// Cost: O(n).
class PaperTracer : public GapTracer {
 public:
  /// All references must outlive the tracer.
  PaperTracer(const WorkingMesh& working, const GeneratorTable& table, Front front, const Progress& progress);

  /// The midpoints of all edges between two labels.
  Crossings cross_edges(const NearestLabels& labels) const override;
  /// Puts these edges, ascending, back to at most one crossing.
  void cross_at_most_once(const std::vector<EdgeId>& edges, const NearestLabels& labels,
                          Crossings& crossings) const override;
  /// Refines the crossings, then fills in the arcs and branch points of all faces, ascending by face.
  void close_faces(TracedDiagram& traced) const override;

 private:
  MidpointDistances midpoints_;
};

}  // namespace gvd
