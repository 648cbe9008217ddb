#include "library_methods.hpp"

#include <algorithm>

#include "gvd/diagram_steps.hpp"
#include "step_clock.hpp"

namespace gvd::paper {
namespace {

bool is_of_field(const std::string& step) {
  return step == steps::kWorkingMesh || step == steps::kDistances || step == steps::kTables;
}

}  // namespace

Comparison run_library_method(const Mesh& mesh, const std::vector<SurfacePoint>& generators, DiagramOptions options) {
  Comparison result;
  bench::StepClock clock;
  options.threads = 1;
  options.progress = clock.progress();
  result.diagram = compute_diagram(mesh, generators, options);
  for (const auto& [step, milliseconds] : clock.finish()) {
    (is_of_field(step) ? result.field_ms : result.diagram_ms) += milliseconds;
  }
  for (const Cell& cell : result.diagram.cells) result.faults.islands += std::max(0, cell.components - 1);
  result.faults.open_ends = result.diagram.report.unresolved_ends;
  return result;
}

}  // namespace gvd::paper
