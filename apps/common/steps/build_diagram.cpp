#include "common/steps/build_diagram.hpp"

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "common/run/step_times.hpp"
#include "gvd/text.hpp"

namespace gvd::app {

namespace {

/// Computes the diagram, and reports the time of each of its steps as "diagram: step".
Diagram compute_timed(Run& run, const Mesh& mesh, const std::vector<SurfacePoint>& generators) {
  DiagramOptions options = make_diagram_options(run.options().compute);
  StepTimes times(run);
  std::string current;
  options.progress = [&, show = run.progress()](std::string_view step, double fraction) {
    if (step != current) {
      current = step;
      times.start(fmt::format("diagram: {}", step));
    }
    return show(step, fraction);
  };
  return compute_diagram(mesh, generators, options);
}

}  // namespace

Diagram build_diagram(Run& run, const Mesh& mesh, const std::vector<SurfacePoint>& generators) {
  Diagram diagram = run.timed("diagram", [&] { return compute_timed(run, mesh, generators); });
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
