#include "common/steps/build_diagram.hpp"

#include <fmt/format.h>

namespace gvd::app {

Diagram build_diagram(Run& run, const Mesh& mesh, const std::vector<SurfacePoint>& generators) {
  DiagramOptions options = make_diagram_options(run.options().compute);
  options.progress = run.progress();
  Diagram diagram = run.timed("diagram", [&] { return compute_diagram(mesh, generators, options); });
  report_diagram(run, diagram);
  return diagram;
}

void report_diagram(Run& run, const Diagram& diagram) {
  run.report().set_diagram(diagram);
  run.console().note(fmt::format("{} cells, {} branch points, {} bisectors of length {:.6g}", diagram.cells.size(),
                                 diagram.branch_points.size(), diagram.bisectors.size(), diagram.length));
  if (diagram.report.straightened_faces > 0) {
    const std::int64_t faces = diagram.report.straightened_faces;
    run.console().note(fmt::format(
        "bisectors are straightened in {} {}; there they are nearer to one generator than to the other by up to {:.3g}",
        faces, faces == 1 ? "face" : "faces", diagram.report.straightened_error));
  }
  if (diagram.report.unresolved_ends > 0) {
    run.console().note(fmt::format("the diagram is not complete: {} ends of bisectors have no branch point",
                                   diagram.report.unresolved_ends));
  }
}

}  // namespace gvd::app
