#pragma once

#include <vector>

#include "diagram/graph/traced_diagram.hpp"
#include "gvd/diagram.hpp"
#include "gvd/progress.hpp"

namespace gvd {

/// A tracer whose cells come out connected, whatever the distances say.
///
/// It crosses the edges, closes the faces, and looks whether every piece hangs together with its generator. Where one
/// does not, growth gives way, vertices take the label of a neighbour and edges are crossed at most once; then the
/// faces are closed again. The last resort, after a number of rounds, is a diagram whose cells are connected by
/// construction.
/// Source: the paper leaves this open; see docs/developer/algorithm.md.
class ConnectedTracer {
 public:
  virtual ~ConnectedTracer() = default;

  /// Counts relabelled vertices in `report`; reports the steps "bisectors" and its own. Cost: O(n) a round, of which
  /// one is the rule.
  TracedDiagram run(DiagramReport& report);

 protected:
  ConnectedTracer(const WorkingMesh& working, NearestLabels labels, const Progress& progress)
      : working_(working), mesh_(working.mesh()), progress_(progress), labels_(std::move(labels)) {}

  /// The crossings of all edges, between the present labels.
  virtual Crossings cross_edges() = 0;
  /// Crosses these edges, ascending, at most once, between the present labels of their ends.
  virtual void cross_at_most_once(const std::vector<EdgeId>& edges, Crossings& crossings) = 0;
  /// Fills in the arcs and branch points of all faces, ascending by face; may move crossings and labels in `traced`.
  virtual void close_faces(TracedDiagram& traced, DiagramReport& report) = 0;
  /// From now on, closes the faces at these edges by nothing but their crossings.
  virtual void disable_growth(const std::vector<EdgeId>&) {}
  /// The same for all faces.
  virtual void disable_growth_everywhere() {}

  const WorkingMesh& working_;
  const Mesh& mesh_;
  const Progress& progress_;
  NearestLabels labels_;

 private:
  void recross_at_most_once(const std::vector<EdgeId>& edges);
  bool join_islands(TracedDiagram& traced);
  void connect_everywhere();

  Crossings crossings_;
  std::vector<EdgeId> plain_;  // edges whose inside runs were taken away, ascending
  std::int64_t relabelled_ = 0;
  int rounds_ = 0;
};

}  // namespace gvd
