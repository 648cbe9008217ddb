#pragma once

#include <functional>
#include <vector>

#include "diagram/graph/traced_diagram.hpp"
#include "gvd/progress.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {

/// The steps that differ between tracers. EnvelopeTracer, GrowthTracer and PaperTracer have them as member functions.
struct TracerSteps {
  /// The crossings of all edges, between the labels of their ends.
  std::function<Crossings(const NearestLabels&)> cross_edges;
  /// Replaces the crossings of these edges, ascending, by at most one, between the labels of the edge's ends.
  std::function<void(const std::vector<EdgeId>&, const NearestLabels&, Crossings&)> cross_at_most_once;
  /// Fills in the arcs and branch points of all faces, ascending by face; may change the diagram's crossings and
  /// labels.
  std::function<void(TracedDiagram&)> close_faces;
  /// From now on, closes the faces at these edges, ascending, by their crossings alone.
  std::function<void(const std::vector<EdgeId>&)> disable_growth = [](const std::vector<EdgeId>&) {};
};

/// The steps of a tracer, which must outlive them. A tracer without growth has no `disable_growth`.
template <class Tracer>
TracerSteps steps_of(Tracer& tracer) {
  TracerSteps steps;
  steps.cross_edges = [&](const NearestLabels& labels) { return tracer.cross_edges(labels); };
  steps.cross_at_most_once = [&](const std::vector<EdgeId>& edges, const NearestLabels& labels, Crossings& crossings) {
    tracer.cross_at_most_once(edges, labels, crossings);
  };
  steps.close_faces = [&](TracedDiagram& traced) { tracer.close_faces(traced); };
  if constexpr (requires(const std::vector<EdgeId>& edges) { tracer.disable_growth(edges); }) {
    steps.disable_growth = [&](const std::vector<EdgeId>& edges) { tracer.disable_growth(edges); };
  }
  return steps;
}

/// Traces a diagram whose cells are connected, whatever the distances are.
///
/// The edges are crossed and the faces closed; then every piece of a cell has to be connected to the cell's generator.
/// Around a piece that is not, growth is disabled, vertices take the label of a neighbour, edges are crossed at most
/// once, and the faces are closed again. After a fixed number of rounds all edges are crossed at most once, between
/// labels that edges join to their generators: such cells are connected by construction.
/// Source: the paper does not treat this; see docs/developer/algorithm.md.
/// Counts relabelled vertices; reports the step "bisectors" and those of the tracer. Cost: O(n) a round; most diagrams
/// need one.
TracedDiagram trace_connected(const WorkingMesh& working, NearestLabels labels, const TracerSteps& steps,
                              const Progress& progress);

}  // namespace gvd
