#include "common/steps/build_diagram.hpp"

#include <fmt/format.h>

#include "gvd/counted.hpp"

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
  run.figures().regions = std::ssize(diagram.cells);
  run.console().note(fmt::format("{}, {}, {} of length {:.6g}", counted(std::ssize(diagram.cells), "cell", "cells"),
                                 counted(std::ssize(diagram.branch_points), "branch point", "branch points"),
                                 counted(std::ssize(diagram.bisectors), "bisector", "bisectors"), diagram.length));
  if (diagram.report.straightened_faces > 0) {
    run.console().note(fmt::format(
        "bisectors are straightened in {}; there they are nearer to one generator than to the other by up to {:.3g}",
        counted(diagram.report.straightened_faces, "face", "faces"), diagram.report.straightened_error));
  }
  if (diagram.report.unresolved_ends > 0) {
    run.console().note(
        fmt::format("the diagram is not complete: {} no branch point",
                    counted(diagram.report.unresolved_ends, "end of a bisector has", "ends of bisectors have")));
  }
}

}  // namespace gvd::app
