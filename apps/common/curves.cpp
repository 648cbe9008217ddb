// --curves: the boundary loops or the creases of the mesh, or the curves of a file.
//
// The name decides: `boundary`, `creases` and `creases:ANGLE` are words, anything else is a file. A file of such a name
// is reached as ./boundary. Points of a file are moved to the surface as those of a list of generators are. Reports
// have the first point of each curve, so that they have as many generators as there are cells.

#include "common/curves.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <numbers>
#include <optional>
#include <system_error>

#include "common/process.hpp"
#include "common/run_parts.hpp"
#include "gvd/constrained_start.hpp"
#include "gvd/curve_list.hpp"
#include "gvd/error.hpp"
#include "gvd/option_text.hpp"
#include "gvd/text.hpp"

namespace gvd::app {
namespace {

constexpr std::string_view kBoundary = "boundary";

/// Notes and limits are those of a list of generators (run_parts.cpp).
std::vector<GeneratorCurve> read(Run& run, const CheckedMesh& input, const std::string& file) {
  const GeneratorOptions& asked = run.options().generators;
  std::error_code ignored;
  if (file != "-" && !std::filesystem::exists(file, ignored)) {
    throw Error(ErrorCode::unreadable_input,
                fmt::format("--curves {}: there is no such file; write boundary, creases or the name of a file", file));
  }
  const CurveList list = [&] {
    const WaitForInput wait(file);
    return file == "-" ? parse_curves(read_standard_input(), kStandardInput) : read_curves(file);
  }();
  ResolvedGenerators snapped;
  const std::vector<GeneratorCurve> curves = resolve_curves(
      input.mesh, list, {.input_vertices = &input.mesh_vertex, .max_snap = asked.max_snap, .progress = run.progress()},
      snapped);
  if (!asked.max_snap) note_far_entry(run, snapped, input.mesh.bbox_diagonal());
  if (snapped.longest_snap.value_or(0) > 0) {
    run.console().note(fmt::format("points of curves: moved to the surface, by at most {:.4g}", *snapped.longest_snap));
  }
  return curves;
}

/// The curves that a name stands for. A mesh that has none of that kind is refused: there would be no generator.
std::vector<GeneratorCurve> find(Run& run, const CheckedMesh& input, const std::string& name) {
  if (name == kBoundary) {
    auto curves = boundary_curves(input.mesh);
    if (curves.empty()) {
      throw Error(ErrorCode::precondition,
                  "--curves boundary: the mesh is closed and has no boundary; use --curves creases, a file of curves, "
                  "or points");
    }
    return curves;
  }
  const std::optional<double> angle = parse_creases(name, kUsualCreaseAngle);
  if (!angle) return read(run, input, name);
  auto curves = crease_curves(input.mesh, *angle * std::numbers::pi / 180);
  if (curves.empty()) {
    throw Error(ErrorCode::precondition,
                fmt::format("--curves {}: no two faces meet at more than {} degrees; write creases:ANGLE for less",
                            name, *angle));
  }
  return curves;
}

/// Twice where segments lie on each other.
double length_of(const Mesh& mesh, const GeneratorCurve& curve) {
  double length = 0;
  for (const auto& [a, b] : curve.segments) {
    length += (position(mesh, curve.points[a]) - position(mesh, curve.points[b])).norm();
  }
  return length;
}

}  // namespace

std::vector<GeneratorCurve> load_curves(Run& run, const CheckedMesh& input) {
  return run.timed("generators", [&] {
    std::vector<GeneratorCurve> curves = find(run, input, run.options().generators.curves);
    double length = 0;
    for (const GeneratorCurve& curve : curves) {
      length += length_of(input.mesh, curve);
      const SurfacePoint& first = curve.points.front();
      run.report().generators().push_back({first, position(input.mesh, first), std::nullopt});
    }
    run.console().detail(fmt::format("{} of length {:.6g}", counted(std::ssize(curves), "curve", "curves"), length));
    return curves;
  });
}

Diagram build_curve_diagram(Run& run, const Mesh& mesh, const std::vector<GeneratorCurve>& curves) {
  Diagram diagram = run.timed("diagram", [&] {
    return compute_timed(run, run.options().compute.diagram,
                         [&](const DiagramOptions& options) { return compute_diagram(mesh, curves, options); });
  });
  report_diagram(run, diagram);
  return diagram;
}

}  // namespace gvd::app
