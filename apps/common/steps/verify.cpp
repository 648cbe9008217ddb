#include "common/steps/verify.hpp"

#include <fmt/format.h>

#ifdef GVD_HAS_VERIFY
#include "gvd/verify.hpp"
#endif

namespace gvd::app {

#ifdef GVD_HAS_VERIFY

void verify(Run& run, const Mesh& mesh, const Diagram& diagram) {
  if (!run.options().compute.verify) return;
  VerifyOptions options;
  options.threads = run.options().compute.threads;
  options.progress = run.progress();
  const ErrorMeasure error = run.timed("verify", [&] { return verify_diagram(mesh, diagram, options); });
  run.report().set_error_measure(error);
  run.figures().error_integral = error.error_integral;
  run.console().note(
      fmt::format("error against exact distances: E {:.6g} mesh units^2 (the difference of a bisector's two distances, "
                  "integrated along all bisectors), mean {:.6g}, largest {:.6g} mesh units",
                  error.error_integral, error.error_mean, error.error_max));
}

#else

// check_options has refused --verify.
void verify(Run&, const Mesh&, const Diagram&) {}

#endif

}  // namespace gvd::app
