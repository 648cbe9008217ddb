#include "gvd/diagram.hpp"

#include <algorithm>
#include <iterator>

#include "diagram/assemble_faces.hpp"
#include "diagram/cell_topology.hpp"
#include "diagram/diagram_graph.hpp"
#include "diagram/nearest_labels.hpp"
#include "diagram/rough_bisectors.hpp"
#include "geodesic/fast_marching.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {
namespace {

/// Labels and distances of the input's own vertices, without the symbolic offsets.
void take_vertex_labels(const WorkingMesh& working, const NearestLabels& labels, double offset_step, Diagram& diagram) {
  const auto n = static_cast<std::size_t>(working.input().vertex_count());
  diagram.vertex_label.resize(n);
  diagram.vertex_distance.resize(n);
  for (std::int32_t i = 0; i < working.input().vertex_count(); ++i) {
    const VertexId v(i);
    diagram.vertex_label[v] = labels.label[v];
    const double offset = static_cast<double>(labels.label[v].value() + 1) * offset_step;
    diagram.vertex_distance[v] = std::max(0.0, labels.distance[v] - offset);
  }
}

/// Crossings and arcs whose cells are connected. An edge sees the tables of its two faces only, so a run inside it may hang
/// together with nothing; then the edges round the island fall back to the labels of their ends, which are connected by
/// construction. Every round takes at least one more edge, and most diagrams need one or two.
void trace_connected(const WorkingMesh& working, const GeneratorTable& table, Front front, TracedDiagram& traced) {
  std::vector<EdgeId> plain;
  while (true) {
    traced.crossings = find_rough_crossings(working, table, traced.labels, front, plain);
    traced.faces = assemble_faces(working, table, traced.labels, traced.crossings, front);
    const std::vector<EdgeId> islands = CellParts(working, traced).island_edges();
    if (islands.empty()) return;
    std::vector<EdgeId> more;
    std::set_union(plain.begin(), plain.end(), islands.begin(), islands.end(), std::back_inserter(more));
    if (more.size() == plain.size()) return;
    plain = std::move(more);
  }
}

}  // namespace

Diagram compute_diagram(const Mesh& mesh, const std::vector<SurfacePoint>& generators, const DiagramOptions& options) {
  const WorkingMesh working(mesh, generators);
  const FastMarchingResult marched = march(working, options.front, options.progress);
  report_progress(options.progress, "bisectors", 0);
  TracedDiagram traced;
  traced.labels = compute_nearest_labels(working, marched.table);
  trace_connected(working, marched.table, options.front, traced);

  report_progress(options.progress, "cells", 0);
  Diagram diagram;
  diagram.generators = generators;
  diagram.report.propagation_events = marched.events;
  diagram.report.table_entries = static_cast<std::int64_t>(marched.table.entry_count());
  diagram.report.relabelled_samples = traced.labels.relabelled;
  take_vertex_labels(working, traced.labels, marched.offset_step, diagram);
  trace_bisectors(working, traced, diagram);
  collect_cells(working, traced, diagram);
  return diagram;
}

}  // namespace gvd
