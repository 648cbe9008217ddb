#include "common/options/options.hpp"

namespace gvd::app {

std::string stdout_format(const OutputOptions& output) { return output.formats.empty() ? "" : output.formats.front(); }

DiagramOptions make_diagram_options(const ComputeOptions& compute) {
  DiagramOptions options;
  options.method = compute.method;
  options.front = compute.front.value_or(compute.method == Method::paper ? Front::planar : options.front);
  options.chord_tolerance = compute.chord_tolerance.value_or(options.chord_tolerance);
  options.threads = compute.threads;
  return options;
}

}  // namespace gvd::app
