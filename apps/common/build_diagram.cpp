#include <fmt/format.h>

#include "common/pipeline.hpp"
#ifdef GVD_HAS_VERIFY
#include "gvd/verify.hpp"
#endif

namespace gvd::app {

Diagram build_diagram(Run& run, const Mesh& mesh, const std::vector<SurfacePoint>& generators) {
  DiagramOptions options = make_diagram_options(run.options().compute);
  options.progress = run.progress();
  Diagram diagram = run.timed("diagram", [&] { return compute_diagram(mesh, generators, options); });
  run.report().diagram = summarize_diagram(diagram);
  run.console().note(fmt::format("{} cells, {} branch points, {} bisectors of length {:.6g}", diagram.cells.size(),
                                 diagram.branch_points.size(), diagram.bisectors.size(), diagram.length));
  if (diagram.report.unresolved_ends > 0) {
    run.console().note(
        fmt::format("the diagram is not complete: {} ends of bisectors meet nothing", diagram.report.unresolved_ends));
  }
  return diagram;
}

void verify(Run& run, const Mesh& mesh, const Diagram& diagram) {
  if (!run.options().compute.verify) return;
#ifdef GVD_HAS_VERIFY
  VerifyOptions options;
  options.threads = run.options().compute.threads;
  options.progress = run.progress();
  const ErrorMeasure error = run.timed("verify", [&] { return verify_diagram(mesh, diagram, options); });
  if (!run.report().diagram) run.report().diagram = summarize_diagram(diagram);
  run.report().diagram->verify = VerifyFigures{error.error_integral, error.error_max, error.length};
  run.console().note(fmt::format("error against exact distances: E {:.6g}, mean {:.6g}, largest {:.6g}",
                                 error.error_integral, error.error_mean, error.error_max));
#else
  (void)mesh;
  (void)diagram;  // check_options has refused --verify
#endif
}

}  // namespace gvd::app
