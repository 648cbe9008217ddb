#include "gvd/diagram.hpp"

#include <algorithm>

#include "diagram/diagram_graph.hpp"
#include "diagram/trace_growth.hpp"
#include "diagram/trace_envelope.hpp"
#include "geodesic/fast_marching.hpp"
#include "geodesic/window_distances.hpp"
#include "geodesic/window_propagation.hpp"
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

/// Exact distances, and the envelope of them.
Diagram compute_exact(const WorkingMesh& working, const DiagramOptions& options) {
  const Mesh& mesh = working.mesh();
  report_progress(options.progress, "distances", 0);
  PropagationOptions propagation;
  propagation.keep = KeepWindows::near_bisectors;
  const WindowField field = propagate_windows(mesh, working.generator_vertices().raw(), propagation, options.progress);
  Diagram diagram;
  const NearestLabels labels = take_labels(working, field.distance, field.label);
  const TracedDiagram traced =
      trace_envelope(working, labels, WindowDistances(mesh, field), options.chord_tolerance * mesh.mean_edge_length(),
                     options.progress, diagram.report);
  report_progress(options.progress, "cells", 0);
  diagram.report.propagation_events = field.carried;
  take_vertex_labels(working, traced.labels, 0, diagram);
  trace_bisectors(working, traced, diagram);
  collect_cells(working, traced, diagram);
  return diagram;
}

}  // namespace

Diagram compute_diagram(const Mesh& mesh, const std::vector<SurfacePoint>& generators, const DiagramOptions& options) {
  const WorkingMesh working(mesh, generators);
  if (options.method == Method::exact) {
    Diagram diagram = compute_exact(working, options);
    diagram.generators = generators;
    return diagram;
  }
  const FastMarchingResult marched = march(working, options.front, options.progress);
  Diagram diagram;
  const TracedDiagram traced = trace_growth(working, marched.table, options, diagram.report);
  report_progress(options.progress, "cells", 0);
  diagram.generators = generators;
  diagram.report.propagation_events = marched.events;
  diagram.report.table_entries = static_cast<std::int64_t>(marched.table.entry_count());
  take_vertex_labels(working, traced.labels, marched.offset_step, diagram);
  trace_bisectors(working, traced, diagram);
  collect_cells(working, traced, diagram);
  return diagram;
}

}  // namespace gvd
